//! The impl by which a model has `MembersInLanes`: members of an ensemble with parameters of their own share SIMD lanes.

use proc_macro2::{Group, TokenStream, TokenTree};
use quote::{ToTokens, quote};
use syn::{GenericParam, Generics, WherePredicate};

use super::parameters::mentions;
use crate::syntax::declaration::Declaration;
use crate::syntax::names::hygienic_ident;
use crate::syntax::scalar::Scalar;

/// The impl, for a model with Taylor series whose external functions do not read the fields of one member, and that is on every scalar
/// or has a type parameter for it. Without equations it has no body.
pub(super) fn members_in_lanes(
    declaration: &Declaration,
    scalar: &Scalar<'_>,
    has_equations: bool,
) -> Option<TokenStream> {
    let mut functions = declaration.clauses.functions.iter();
    if functions.any(|function| mentions(&function.value.to_token_stream(), "self")) {
        return None;
    }
    if scalar.is_generic() {
        return Some(of_plain_numbers(declaration));
    }
    declaration.clauses.taylor.as_ref()?;
    let parameter = scalar_parameter(&declaration.generics, scalar)?;
    Some(of_type_parameter(declaration, &parameter, has_equations))
}

/// The name of the type parameter that is the scalar and nothing else: its place may be taken by `f64` and lanes.
fn scalar_parameter(generics: &Generics, scalar: &Scalar<'_>) -> Option<String> {
    let name = scalar.to_token_stream().to_string();
    let (own, others): (Vec<_>, Vec<_>) = generics
        .params
        .iter()
        .partition(|other| matches!(other, GenericParam::Type(other) if other.ident == name));
    let mut others = others.iter().map(ToTokens::to_token_stream);
    let conditions = conditions_beside(generics, &name);
    let is_free = !scalar.is_ambiguous()
        && !others.any(|other| mentions(&other, &name))
        && !conditions
            .into_iter()
            .any(|condition| mentions(&condition, &name));
    (!own.is_empty() && is_free).then_some(name)
}

/// The conditions of a `where` clause, but those on the scalar itself.
fn conditions_beside(generics: &Generics, scalar: &str) -> Vec<TokenStream> {
    let conditions = generics.where_clause.iter();
    let conditions = conditions.flat_map(|conditions| &conditions.predicates);
    let beside = conditions.filter_map(|condition| match condition {
        WherePredicate::Type(of_type)
            if of_type.bounded_ty.to_token_stream().to_string() == scalar =>
        {
            None
        }
        other => Some(other.to_token_stream()),
    });
    beside.collect()
}

/// A model on every scalar: a member serves all lanes.
fn of_plain_numbers(declaration: &Declaration) -> TokenStream {
    let Declaration {
        root,
        name,
        generics,
        ..
    } = declaration;
    let (parameters, arguments, conditions) = generics.split_for_impl();
    quote! {
        #[automatically_derived]
        impl #parameters #root::__private::SharesLanes for #name #arguments #conditions {}
    }
}

/// A model with a type parameter for its scalar: with `f64` in its place it is a member, with lanes a model of all.
fn of_type_parameter(
    declaration: &Declaration,
    parameter: &str,
    has_equations: bool,
) -> TokenStream {
    let Declaration {
        root,
        name,
        generics,
        fields,
        ..
    } = declaration;
    let lanes = hygienic_ident("__LANES", name);
    let alone = quote!(::core::primitive::f64);
    let together = quote!(#root::Lanes<#lanes>);
    let mut others = generics.clone();
    others.params = generics
        .params
        .iter()
        .filter(|other| !matches!(other, GenericParam::Type(other) if other.ident == parameter))
        .cloned()
        .collect();
    others
        .params
        .push(syn::parse_quote!(const #lanes: ::core::primitive::usize));
    let (parameters, _, _) = others.split_for_impl();
    let (_, arguments, _) = generics.split_for_impl();
    let mut bounds = conditions_beside(generics, parameter);
    let on = |tokens: TokenStream, scalar: &TokenStream| replaced(tokens, parameter, scalar);
    let arguments = arguments.to_token_stream();
    let [member, model] = [&alone, &together].map(|scalar| on(arguments.clone(), scalar));
    let mut values = Vec::new();
    for field in fields {
        let (name, ty) = (&field.name, field.ty.to_token_stream());
        let own = on(ty.clone(), &alone);
        if mentions(&ty, parameter) {
            let of_lanes = on(ty, &together);
            let is_in_lanes = quote!(#root::__private::InEveryLane<#lanes>);
            bounds.push(quote!(#own: #root::__private::InEveryLane<#lanes, InLanes = #of_lanes>));
            values.push(quote!(#name: <#own as #is_in_lanes>::in_every_lane(&self.#name)));
        } else {
            let is_kept = quote!(#root::__private::Kept<#lanes>);
            bounds.push(quote!(#own: #is_kept));
            values.push(quote!(#name: <#own as #is_kept>::kept(&self.#name)));
        }
    }
    let body = if has_equations {
        quote!(#name { #(#values),* })
    } else {
        quote!(::core::unreachable!())
    };
    quote! {
        #[automatically_derived]
        impl #parameters #root::quantities::MembersInLanes<#lanes> for #name #member
        where #(#bounds),*
        {
            type InLanes = #name #model;
            type Made = #name #model;
            fn make(&self) -> #name #model { #body }
            fn in_lanes<'__made>(&'__made self, made: &'__made #name #model) -> &'__made #name #model { made }
        }
    }
}

/// The tokens with a type in place of a type parameter.
fn replaced(tokens: TokenStream, parameter: &str, ty: &TokenStream) -> TokenStream {
    let replace = |token: TokenTree| match token {
        TokenTree::Ident(ident) if ident == parameter => ty.clone(),
        TokenTree::Group(group) => {
            let inner = replaced(group.stream(), parameter, ty);
            let mut replaced = Group::new(group.delimiter(), inner);
            replaced.set_span(group.span());
            TokenTree::Group(replaced).into()
        }
        other => other.into(),
    };
    tokens.into_iter().map(replace).collect()
}
