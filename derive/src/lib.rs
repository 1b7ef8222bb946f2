//! The derive macro of the `lagrangian` crate: words in, words out.

mod expand;
mod validation;
mod diagnostics;
mod declaration;
mod clauses;
mod coordinate;
mod named;
mod grammar;
mod field;
mod field_type;
mod function;
mod root;
mod scalar;
mod check;
mod value;
mod quantities;
mod scope;
mod expression;
mod hints;
mod ablation;
mod lower;
mod defects;
mod plan;
mod names;
mod body;
mod mentions;
mod implementation;
mod documentation;
mod fallback;
#[cfg(test)]
mod golden;
#[cfg(test)]
mod half_typed;
#[cfg(test)]
mod robustness;
#[cfg(test)]
mod timing;

use proc_macro::TokenStream;

/// Derives the equations of motion from the energies declared on a struct of parameters.
///
/// The declaration language is described in the documentation of the crate `lagrangian`.
#[proc_macro_derive(Lagrangian, attributes(lagrangian))]
pub fn derive_lagrangian(input: TokenStream) -> TokenStream {
    expand::expand(input.into()).into()
}
