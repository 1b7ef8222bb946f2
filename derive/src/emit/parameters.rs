//! The parameters of emitted methods.

use proc_macro2::{Ident, TokenStream, TokenTree};
use quote::format_ident;

use crate::plan::PARAMETERS;

/// The parameters of a method, with an underscore before those that its body does not use.
pub(super) fn marked_if_unused(parameters: TokenStream, body: &TokenStream) -> TokenStream {
    let mut tokens: Vec<_> = parameters.into_iter().collect();
    let names = tokens.iter_mut().filter_map(|token| match token {
        TokenTree::Ident(name) => {
            let known = PARAMETERS.iter().find(|known| name == *known)?;
            Some((name, *known))
        }
        _ => None,
    });
    let mut unused = names.collect();
    remove_mentioned(body.clone(), &mut unused);
    for (name, _) in unused {
        *name = format_ident!("_{name}");
    }
    tokens.into_iter().collect()
}

/// Removes the names that occur in some tokens, in one pass: bodies are long.
fn remove_mentioned(tokens: TokenStream, names: &mut Vec<(&mut Ident, &str)>) {
    for token in tokens {
        if names.is_empty() {
            return;
        }
        match token {
            TokenTree::Ident(ident) => names.retain(|(_, name)| ident != name),
            TokenTree::Group(group) => remove_mentioned(group.stream(), names),
            _ => {}
        }
    }
}

/// Whether a name occurs in some tokens.
pub(super) fn mentions(tokens: &TokenStream, name: &str) -> bool {
    tokens.clone().into_iter().any(|token| match token {
        TokenTree::Ident(ident) => ident == name,
        TokenTree::Group(group) => mentions(&group.stream(), name),
        _ => false,
    })
}
