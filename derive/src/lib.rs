//! The derive macro of the `lagrangian` crate.

use proc_macro::TokenStream;

/// Derives the equations of motion.
#[proc_macro_derive(Lagrangian, attributes(lagrangian))]
pub fn derive_lagrangian(_input: TokenStream) -> TokenStream {
    TokenStream::new()
}
