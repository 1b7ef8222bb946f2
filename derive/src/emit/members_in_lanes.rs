//! The impl by which a model has `MembersInLanes`: members of an ensemble with parameters of their own share SIMD lanes.

use proc_macro2::TokenStream;
use quote::{ToTokens, quote};
use syn::GenericParam;

use super::implementation;
use super::on_another_scalar::{OnAnotherScalar, conditions_beside, replaced, scalar_parameter};
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

/// A model on every scalar: a member serves all lanes.
fn of_plain_numbers(declaration: &Declaration) -> TokenStream {
    let Declaration { root, generics, .. } = declaration;
    let interface = quote!(#root::__private::SharesLanes);
    implementation::of_trait(declaration, generics, &interface, &TokenStream::new())
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
    let converted = OnAnotherScalar::of(declaration, parameter, [&alone, &together]);
    bounds.extend(converted.bounds);
    let body = if has_equations {
        converted.value
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
