//! The parameters of emitted methods.

use proc_macro2::{TokenStream, TokenTree};
use quote::format_ident;

use crate::plan::PARAMETERS;

/// The parameters of a method, with an underscore before those that its body does not use.
pub(super) fn marked_if_unused(parameters: TokenStream, body: &TokenStream) -> TokenStream {
    let mut tokens = Vec::new();
    for token in parameters {
        match token {
            TokenTree::Ident(name) if PARAMETERS.iter().any(|known| name == known) => {
                let unused = !mentions(body, &name.to_string());
                tokens.push(if unused {
                    format_ident!("_{name}").into()
                } else {
                    TokenTree::Ident(name)
                });
            }
            token => tokens.push(token),
        }
    }
    tokens.into_iter().collect()
}

/// Whether a name occurs in some tokens.
pub(super) fn mentions(tokens: &TokenStream, name: &str) -> bool {
    tokens.clone().into_iter().any(|token| match token {
        TokenTree::Ident(ident) => ident == name,
        TokenTree::Group(group) => mentions(&group.stream(), name),
        _ => false,
    })
}
