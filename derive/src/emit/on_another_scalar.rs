//! A struct with a type parameter for its scalar, with another scalar in its place.

use proc_macro2::{Group, TokenStream, TokenTree};
use quote::{ToTokens, quote};
use syn::{GenericParam, Generics, WherePredicate};

use super::parameters::mentions;
use crate::syntax::declaration::Declaration;
use crate::syntax::scalar::Scalar;

/// The fields of a struct on another scalar.
pub(super) struct OnAnotherScalar {
    /// What the types of the fields fulfil, so that they can be converted.
    pub(super) bounds: Vec<TokenStream>,
    /// The struct with the values of `self`.
    pub(super) value: TokenStream,
}

impl OnAnotherScalar {
    /// Converts the fields of a struct whose type parameter for its scalar stands for `own` to `other`.
    pub(super) fn of(
        declaration: &Declaration,
        parameter: &str,
        [own, other]: [&TokenStream; 2],
    ) -> Self {
        let root = &declaration.root;
        let mut bounds = Vec::new();
        let mut values = Vec::new();
        for field in &declaration.fields {
            let (name, ty) = (&field.name, field.ty.to_token_stream());
            let of_own = replaced(ty.clone(), parameter, own);
            if mentions(&ty, parameter) {
                let of_other = replaced(ty, parameter, other);
                let is_converted = quote!(#root::__private::OnScalar<#other>);
                bounds.push(
                    quote!(#of_own: #root::__private::OnScalar<#other, OnScalar = #of_other>),
                );
                values.push(quote!(#name: <#of_own as #is_converted>::on_scalar(&self.#name)));
            } else {
                let is_kept = quote!(#root::__private::Kept<#other>);
                bounds.push(quote!(#of_own: #is_kept));
                values.push(quote!(#name: <#of_own as #is_kept>::kept(&self.#name)));
            }
        }
        let name = &declaration.name;
        Self {
            bounds,
            value: quote!(#name { #(#values),* }),
        }
    }
}

/// The name of the type parameter that is the scalar and nothing else: another scalar may take its place.
pub(super) fn scalar_parameter(generics: &Generics, scalar: &Scalar<'_>) -> Option<String> {
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
pub(super) fn conditions_beside(generics: &Generics, scalar: &str) -> Vec<TokenStream> {
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

/// The tokens with a type in place of a type parameter.
pub(super) fn replaced(tokens: TokenStream, parameter: &str, ty: &TokenStream) -> TokenStream {
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
