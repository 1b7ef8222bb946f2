//! The derive macro of the `lagrangian` crate: Rust tokens in, Rust tokens out.

// A module imports only from those before it (`.ci/imports`).
mod limits;
mod diagnostics;
mod syntax;
mod lower;
mod plan;
mod check;
mod reduce;
mod emit;
mod defects;
mod derived;
mod expand;
#[cfg(test)]
mod tests;

use proc_macro::TokenStream;

/// Derives the equations of motion from the energies declared on a struct of parameters.
///
/// The declaration language is described in the documentation of the crate `lagrangian`.
#[proc_macro_derive(Lagrangian, attributes(lagrangian))]
pub fn derive_lagrangian(input: TokenStream) -> TokenStream {
    expand::expand(input.into()).into()
}
