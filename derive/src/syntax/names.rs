//! Names as the declaration writes them, and as the emitted code does.

use proc_macro2::{Ident, Span};

/// Names with a meaning in the declaration language, which nothing else can have.
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

/// A name where `at` stands, with the hygiene of the macro: what the user's lints would say of it does
/// not concern the user.
pub(crate) fn hygienic_ident(name: &str, at: &Ident) -> Ident {
    Ident::new(name, hygienic_span(at))
}

/// The place of a name, with the hygiene of the macro.
pub(crate) fn hygienic_span(at: &Ident) -> Span {
    Span::mixed_site().located_at(at.span())
}

/// The name without `r#`.
pub(crate) fn unraw(name: &Ident) -> String {
    let written = name.to_string();
    written.strip_prefix("r#").unwrap_or(&written).to_owned()
}

/// The name as the declaration has to write it: with `r#` if it is a keyword.
pub(crate) fn to_source(name: &str) -> String {
    match syn::parse_str::<Ident>(name) {
        Ok(_) => name.to_owned(),
        Err(_) => format!("r#{name}"),
    }
}
