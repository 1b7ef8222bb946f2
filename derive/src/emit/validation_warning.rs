//! A warning where validation found a bug of this crate.

use std::collections::BTreeSet;

use lagrangian_symbolic as symbolic;
use proc_macro2::TokenStream;
use quote::{format_ident, quote_spanned};

use crate::syntax::declaration::Declaration;

/// Warns in a debug build of the macro that methods had to be replaced: by the use of something deprecated, since
/// macros on stable Rust cannot emit warnings.
pub(crate) fn warning(
    disagreements: &BTreeSet<symbolic::Method>,
    declaration: &Declaration,
) -> Option<TokenStream> {
    if !cfg!(debug_assertions) || disagreements.is_empty() {
        return None;
    }
    let methods: Vec<String> = disagreements
        .iter()
        .map(|method| format!("{method:?}"))
        .collect();
    let note = format!(
        "the simplified code for {} does not compute what Lagrange's equations say, so that the plain code is used, \
         which is right and slower; this is a defect of `lagrangian`: please report the declaration",
        methods.join(", ")
    );
    let name = format_ident!("DEFECT_OF_LAGRANGIAN", span = declaration.name.span());
    Some(quote_spanned! {declaration.name.span()=>
        const _: () = {
            #[deprecated(note = #note)]
            const #name: () = ();
            #name
        };
    })
}
