//! Identifiers, in the declaration and in the emitted code.

use proc_macro2::{Ident, Span};

/// The reserved names of the declaration language.
pub(crate) const RESERVED: [&str; 3] = ["t", "PI", "dot"];

/// The constant that holds a coordinate's index: its name in capitals. Names outside of ASCII stay as
/// they are, since θ and Θ together are what the compiler warns of as confusable.
pub(crate) fn constant_name(coordinate: &Ident) -> String {
    let name = unraw(coordinate);
    if name.is_ascii() {
        name.to_ascii_uppercase()
    } else {
        name
    }
}

/// An identifier at the place of `at`, with the hygiene of the macro: the user's lints do not apply to it.
pub(crate) fn hygienic_ident(name: &str, at: &Ident) -> Ident {
    Ident::new(name, hygienic_span(at))
}

/// The span of a name, with the hygiene of the macro.
pub(crate) fn hygienic_span(at: &Ident) -> Span {
    Span::mixed_site().located_at(at.span())
}

/// The name without `r#`.
pub(crate) fn unraw(name: &Ident) -> String {
    let written = name.to_string();
    written.strip_prefix("r#").unwrap_or(&written).to_owned()
}

/// The name in source code: with `r#` if it is a keyword.
pub(crate) fn to_source(name: &str) -> String {
    match syn::parse_str::<Ident>(name) {
        Ok(_) => name.to_owned(),
        Err(_) => format!("r#{name}"),
    }
}
