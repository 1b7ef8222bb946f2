//! The scalar on which the emitted impls compute.
//!
//! It is decided here and nowhere else. A struct of plain numbers is a model on every scalar, which is then
//! a parameter of each impl. A struct with fields of a type parameter, `struct Top<T: Scalar>`, is a model
//! on that one: its parameters may carry derivatives, or differ from lane to lane. And `scalar = f64` makes a
//! model on that scalar alone, which may use functions that are not of every scalar.

use proc_macro2::{Ident, Span, TokenStream};
use quote::{ToTokens, quote};
use syn::{Generics, PathSegment, TraitBound, Type, TypeParamBound, WherePredicate, parse_quote};

use crate::declaration::Declaration;
use crate::diagnostics::Diagnostics;
use crate::field::Role;
use crate::root::Root;

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
    /// Of nothing: it is the type that `scalar = …` names. Methods of its own may be called as those of the
    /// trait.
    Nothing,
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
        let (name, owner) = match (uses(declaration).next(), &declaration.clauses.scalar) {
            (None, None) => (parameter_of_impls().into_token_stream(), Owner::Impl),
            (None, Some(named)) => (named.to_token_stream(), Owner::Nothing),
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
            Owner::Struct | Owner::StructAmongBounds | Owner::Nothing => {}
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

    /// Whether methods of the scalar must be called as functions of the trait.
    pub(crate) fn is_ambiguous(&self) -> bool {
        matches!(self.owner, Owner::StructAmongBounds | Owner::Nothing)
    }

    /// Whether the impls are on every scalar.
    pub(crate) fn is_every(&self) -> bool {
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
            Owner::Nothing => parameter_of_impls().into_token_stream(),
            _ => self.name.clone(),
        }
    }
}

/// What is a parameter of each impl.
fn parameter_of_impls() -> Ident {
    Ident::new("__S", Span::mixed_site())
}

/// Checks that the fields' type parameters are one, and a scalar, and no other than is named.
pub(crate) fn check(declaration: &Declaration, diagnostics: &mut Diagnostics) {
    if let (Some(named), Some((used, _))) = (&declaration.clauses.scalar, uses(declaration).next())
        && !is_name(named, used)
    {
        let message =
            format!("parameters are of `{used}`: write `scalar = {used}`, or leave it out");
        return diagnostics.error(named, message);
    }
    let mut checked: Vec<&Ident> = Vec::new();
    for (parameter, ty) in uses(declaration) {
        if checked.contains(&parameter) {
            continue;
        }
        let model = &declaration.name;
        if !is_scalar(&declaration.generics, parameter) {
            let message = format!(
                "`{parameter}` may be of any type: write `struct {model}<{parameter}: Scalar>`, with the trait \
                 `lagrangian::Scalar`"
            );
            diagnostics.error(ty, message);
        } else if let [first, ..] = checked[..] {
            let message = format!(
                "parameters are of one scalar, and others are of `{first}`: write `{first}`, or `f64`"
            );
            diagnostics.error(ty, message);
        }
        checked.push(parameter);
    }
}

/// The type parameter of `generics` that `ty` is.
pub(crate) fn type_parameter<'a>(generics: &'a Generics, ty: &Type) -> Option<&'a Ident> {
    let name = named(ty)?;
    let parameters = generics.type_params().map(|parameter| &parameter.ident);
    parameters.into_iter().find(|parameter| *parameter == name)
}

/// The type parameters that parameters and inputs are of, in the order of the fields; then the one that is
/// named as the scalar.
fn uses(declaration: &Declaration) -> impl Iterator<Item = (&Ident, &Type)> {
    let fields = declaration.fields.iter();
    let named = declaration.clauses.scalar.iter().filter_map(|named| {
        let parameter = type_parameter(&declaration.generics, named)?;
        Some((parameter, named))
    });
    fields
        .filter(|field| field.role != Role::Skipped)
        .filter_map(|field| {
            let element = field.form().ok()?.element;
            let parameter = type_parameter(&declaration.generics, element)?;
            Some((parameter, element))
        })
        .chain(named)
}

fn is_name(ty: &Type, name: &Ident) -> bool {
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
fn is_scalar(generics: &Generics, parameter: &Ident) -> bool {
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

#[cfg(test)]
mod tests {
    use crate::expand::expand;

    const HEAVY_TOP: &str = include_str!("../golden/heavy_top/declaration.rs");
    const DRIVEN_PENDULUM: &str = include_str!("../golden/driven_pendulum/declaration.rs");

    fn expansion(declaration: &str) -> String {
        expand(declaration.parse().expect("the declaration is of tokens")).to_string()
    }

    /// The declaration with parameters of type `T`.
    fn generic(declaration: &str, name: &str, parameter: &str) -> String {
        declaration.replace(": f64", ": T").replace(
            &format!("struct {name}"),
            &format!("struct {name}<{parameter}>"),
        )
    }

    /// The expansion without what converts plain numbers.
    fn without_conversions(expansion: &str) -> String {
        let mut parts = expansion.split(":: lagrangian :: __private :: parameter (");
        let first = parts.next().unwrap_or_default().to_owned();
        parts.fold(first, |text, part| text + &part.replacen(')', "", 1))
    }

    const MODELS: [(&str, &str); 2] =
        [(HEAVY_TOP, "HeavyTop"), (DRIVEN_PENDULUM, "DrivenPendulum")];

    #[test]
    fn parameters_of_any_scalar_cost_what_plain_numbers_cost() {
        for (declaration, name) in MODELS {
            let plain = expansion(declaration);
            let expected = without_conversions(&plain)
                .replace("__S", "T")
                .replace(":: core :: primitive :: f64", "T")
                .replace("impl < T : :: lagrangian :: Scalar >", "impl")
                .replace("impl ", "impl < T : Scalar > ")
                .replace(&format!("{name} {{"), &format!("{name} < T > {{"));
            assert_eq!(
                expansion(&generic(declaration, name, "T: Scalar")),
                expected
            );
        }
    }

    #[test]
    fn a_named_scalar_stands_in_the_place_of_a_parameter() {
        for (declaration, name) in MODELS {
            let among = expansion(&generic(declaration, name, "T: Scalar + Other"));
            let named = declaration.replacen("#[lagrangian(", "#[lagrangian(scalar = f64, ", 1);
            let named = expansion(&named);
            for (of_parameter, of_type) in [
                (
                    "< T as :: lagrangian :: Scalar >",
                    "< f64 as :: lagrangian :: Scalar >",
                ),
                (": T = self .", ": f64 = self ."),
                (", T >", ", f64 >"),
            ] {
                let count = among.matches(of_parameter).count();
                assert!(count > 0, "{of_parameter}");
                assert_eq!(named.matches(of_type).count(), count, "{name}: {of_type}");
            }
            // Nothing is generic but the struct of outputs, whose field is a number on the scalar.
            let results = named.split("struct ").nth(1).unwrap_or_default();
            let generic = results.matches("__S").count();
            assert_eq!(named.matches("__S").count(), generic, "{name}: {named}");
            assert!(!named.contains("parameter ("), "{name}: {named}");
        }
    }

    #[test]
    fn beside_other_bounds_functions_are_those_of_the_trait() {
        for (declaration, name) in MODELS {
            let alone = expansion(&generic(declaration, name, "T: Scalar"));
            let among = expansion(&generic(declaration, name, "T: Scalar + Other"));
            for function in ["sines_and_cosines", "sin_cos", "mul_add", "from_f64"] {
                assert!(
                    !among.contains(&format!(". {function} (")),
                    "{name}: {among}"
                );
                assert!(
                    !among.contains(&format!("T :: {function} (")),
                    "{name}: {among}"
                );
                let trait_function = format!("< T as :: lagrangian :: Scalar > :: {function} (");
                assert_eq!(
                    among.matches(&trait_function).count(),
                    alone.matches(&format!(" {function} (")).count(),
                    "{name}: {function}"
                );
            }
        }
    }
}
