//! The arguments of the compiler, for tests that call it again.

use std::env;

use proc_macro::{Delimiter, Group, Literal, Punct, Spacing, TokenStream, TokenTree};

/// The command line of the compiler that expands this, program and arguments, as a `[&str; N]`.
///
/// Cargo does not tell a test where the libraries are that it was built with, and several builds of a library may be beside each
/// other. The command line names the right ones.
#[proc_macro]
pub fn compiler_arguments(_: TokenStream) -> TokenStream {
    let entries = env::args().flat_map(|argument| {
        [
            TokenTree::Literal(Literal::string(&argument)),
            TokenTree::Punct(Punct::new(',', Spacing::Alone)),
        ]
    });
    TokenTree::Group(Group::new(Delimiter::Bracket, entries.collect())).into()
}
