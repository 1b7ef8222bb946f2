//! The scalar on which the emitted impls compute.
//!
//! It is decided here and nowhere else. A struct of plain numbers is a model on every scalar, which is then
//! a type parameter of each impl. A struct with fields of a type parameter, `struct Top<T: Scalar>`, is a model
//! on that one: its parameters may carry derivatives, or differ from lane to lane. And `scalar = f64` makes a
//! model on that scalar alone, which may use functions that are not of every scalar.

use proc_macro2::{Ident, Span, TokenStream};
use quote::{ToTokens, quote};
use syn::{Generics, PathSegment, TraitBound, Type, TypeParamBound, WherePredicate, parse_quote};

use crate::syntax::declaration::Declaration;
use crate::syntax::field::Role;
use crate::syntax::field_type::FieldType;
use crate::syntax::root::Root;

/// The scalar of a model's impls. As tokens it is its name.
pub(crate) struct Scalar<'a> {
    name: TokenStream,
    owner: Owner,
    root: &'a Root,
}

/// What a scalar is a parameter of.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Owner {
    /// Of each impl.
    Impl,
    /// Of the struct, which bounds it by `Scalar` alone.
    Struct,
    /// Of the struct, which bounds it by other traits, too; they may have functions of the same names.
    StructAmongBounds,
    /// Of nothing: it is the type of `scalar = …`. It may have methods of its own with the names of the trait's.
    NamedType,
    /// Of the struct, which does not bound it by `Scalar`. That is an error; impls beside it do.
    StructUnbounded,
}

impl ToTokens for Scalar<'_> {
    fn to_tokens(&self, tokens: &mut TokenStream) {
        self.name.to_tokens(tokens);
    }
}

impl<'a> Scalar<'a> {
    pub(crate) fn of(declaration: &'a Declaration) -> Self {
        let generics = &declaration.generics;
        let (name, owner) = match (
            scalar_parameters(declaration).next(),
            &declaration.clauses.scalar,
        ) {
            (None, None) => (parameter_of_impls().into_token_stream(), Owner::Impl),
            (None, Some(named)) => (named.to_token_stream(), Owner::NamedType),
            (Some((name, _)), _) => {
                let owner = match (is_scalar(generics, name), bounds(generics, name).count()) {
                    (false, _) => Owner::StructUnbounded,
                    (true, 1) => Owner::Struct,
                    (true, _) => Owner::StructAmongBounds,
                };
                (name.to_token_stream(), owner)
            }
        };
        Self {
            name,
            owner,
            root: &declaration.root,
        }
    }

    /// The generics of an impl on the scalar, for a struct that has those `declared`.
    pub(crate) fn generics(&self, declared: &Generics) -> Generics {
        let Self { name, root, .. } = self;
        let mut generics = declared.clone();
        match self.owner {
            Owner::Impl => generics.params.push(parse_quote!(#name: #root::Scalar)),
            Owner::Struct | Owner::StructAmongBounds | Owner::NamedType => {}
            Owner::StructUnbounded => {
                let conditions = &mut generics.make_where_clause().predicates;
                conditions.push(parse_quote!(#name: #root::Scalar));
            }
        }
        generics
    }

    /// The value on the scalar of what `place` holds, which is of type `ty`.
    pub(crate) fn read(&self, place: &TokenStream, ty: &Type) -> TokenStream {
        let root = self.root;
        if self.is(ty) {
            place.clone()
        } else {
            quote!(#root::__private::parameter(#place))
        }
    }

    /// What the functions of the trait `Scalar` are called on: the scalar, or `<T as Scalar>` where others
    /// may have the same names.
    pub(crate) fn functions(&self) -> TokenStream {
        let Self { name, root, .. } = self;
        if self.is_ambiguous() {
            quote!(<#name as #root::Scalar>)
        } else {
            name.clone()
        }
    }

    /// The type parameters of functions beside the impls, on the same scalar.
    pub(crate) fn generics_of_functions(&self) -> Option<TokenStream> {
        let Self { name, root, owner } = self;
        (*owner != Owner::NamedType).then(|| quote!(<#name: #root::Scalar>))
    }

    /// Where emitted paths begin.
    pub(crate) const fn root(&self) -> &'a Root {
        self.root
    }

    /// Whether methods of the scalar must be called as functions of the trait.
    pub(crate) fn is_ambiguous(&self) -> bool {
        matches!(self.owner, Owner::StructAmongBounds | Owner::NamedType)
    }

    /// Whether the impls are on every scalar.
    pub(crate) fn is_generic(&self) -> bool {
        self.owner == Owner::Impl
    }

    /// Whether `ty` is the scalar.
    pub(crate) fn is(&self, ty: &Type) -> bool {
        self.owner != Owner::Impl && ty.to_token_stream().to_string() == self.name.to_string()
    }

    /// The scalar of the parameters: `f64` for those of plain numbers, whose impls are on every scalar.
    pub(crate) fn of_parameters(&self) -> TokenStream {
        match self.owner {
            Owner::Impl => quote!(::core::primitive::f64),
            _ => self.name.clone(),
        }
    }

    /// What the parameter of a struct of results is called, which has one whatever the scalar is.
    pub(crate) fn of_results(&self) -> TokenStream {
        match self.owner {
            Owner::NamedType => parameter_of_impls().into_token_stream(),
            _ => self.name.clone(),
        }
    }
}

/// The type parameter of each impl.
fn parameter_of_impls() -> Ident {
    Ident::new("__S", Span::mixed_site())
}

/// The type parameter of `generics` that `ty` is.
pub(crate) fn type_parameter<'a>(generics: &'a Generics, ty: &Type) -> Option<&'a Ident> {
    let name = named(ty)?;
    let parameters = generics.type_params().map(|parameter| &parameter.ident);
    parameters.into_iter().find(|parameter| *parameter == name)
}

/// Whether a model is one on `f64`: where a clause names its scalar, that is a type parameter of the struct, or `f64`.
pub(crate) fn computes_on_f64(declaration: &Declaration) -> bool {
    declaration.clauses.scalar.as_ref().is_none_or(|scalar| {
        type_parameter(&declaration.generics, scalar).is_some()
            || scalar.to_token_stream().to_string().ends_with("f64")
    })
}

/// The type parameters that parameters and inputs are of, in the order of the fields; then the one that is
/// named as the scalar.
pub(crate) fn scalar_parameters(
    declaration: &Declaration,
) -> impl Iterator<Item = (&Ident, &Type)> {
    let fields = declaration.fields.iter();
    let named = declaration.clauses.scalar.iter().filter_map(|named| {
        let parameter = type_parameter(&declaration.generics, named)?;
        Some((parameter, named))
    });
    fields
        .filter(|field| field.role != Role::Skipped)
        .filter_map(|field| {
            let element = field.field_type().ok()?.element?;
            let parameter = type_parameter(&declaration.generics, element)?;
            Some((parameter, element))
        })
        .chain(named)
}

pub(crate) fn is_name(ty: &Type, name: &Ident) -> bool {
    named(ty).is_some_and(|named| named == name)
}

/// The name that a type is, if it is nothing but a name.
fn named(ty: &Type) -> Option<&Ident> {
    match ty {
        Type::Path(path) if path.qself.is_none() => path.path.get_ident(),
        Type::Group(group) => named(&group.elem),
        Type::Paren(paren) => named(&paren.elem),
        _ => None,
    }
}

/// Whether a type parameter is bounded by `Scalar`, by any path but that of nalgebra's trait of this name.
pub(crate) fn is_scalar(generics: &Generics, parameter: &Ident) -> bool {
    bounds(generics, parameter).any(|bound| {
        let segments = &bound.path.segments;
        let is = |segment: Option<&PathSegment>, name| {
            segment.is_some_and(|segment| segment.ident == name)
        };
        is(segments.last(), "Scalar") && !is(segments.first(), "nalgebra")
    })
}

/// The traits that a type parameter is bounded by, where it is declared and under `where`.
fn bounds<'a>(
    generics: &'a Generics,
    parameter: &'a Ident,
) -> impl Iterator<Item = &'a TraitBound> {
    let declared = generics
        .type_params()
        .filter(move |declared| declared.ident == *parameter)
        .map(|declared| &declared.bounds);
    let conditions = generics.where_clause.iter().flat_map(|all| &all.predicates);
    let demanded = conditions.filter_map(move |condition| match condition {
        WherePredicate::Type(condition) if named(&condition.bounded_ty) == Some(parameter) => {
            Some(&condition.bounds)
        }
        _ => None,
    });
    declared
        .chain(demanded)
        .flatten()
        .filter_map(|bound| match bound {
            TypeParamBound::Trait(bound) => Some(bound),
            _ => None,
        })
}

/// Whether the components of a field are numbers: where their type is written, plain ones or the scalar of the model.
pub(crate) fn has_numbers(declaration: &Declaration, field_type: &FieldType<'_>) -> bool {
    field_type
        .element
        .is_none_or(|element| is_number(declaration, element))
}

/// Whether a type is one of plain numbers, or the scalar of a generic struct.
pub(crate) fn is_number(declaration: &Declaration, ty: &Type) -> bool {
    let scalar = Scalar::of(declaration);
    type_parameter(&declaration.generics, ty).is_some() || is_float(ty) || scalar.is(ty)
}

fn is_float(ty: &Type) -> bool {
    match ty {
        Type::Path(path) => {
            let last = path.path.segments.last();
            last.is_some_and(|last| last.ident == "f64" || last.ident == "f32")
        }
        Type::Group(group) => is_float(&group.elem),
        Type::Paren(paren) => is_float(&paren.elem),
        _ => false,
    }
}
