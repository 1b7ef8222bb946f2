//! Parsers that clauses share: words, lists, expressions after an equals sign.

use proc_macro2::{Ident, Span, TokenTree};
use syn::ext::IdentExt;
use syn::parse::discouraged::Speculative;
use syn::parse::{ParseBuffer, ParseStream};
use syn::{Attribute, Expr, Token, token};

use crate::syntax::other_notation;

/// `= expression` after a word.
pub(crate) fn equated(word: &Ident, input: ParseStream<'_>) -> syn::Result<Expr> {
    expression(word, &format!("write `{word} = expression`"), input)
}

/// `= expression` after a word, or an error that says how to write it.
pub(crate) fn expression(word: &Ident, message: &str, input: ParseStream<'_>) -> syn::Result<Expr> {
    equals(word, message, input)?;
    let written = input.fork();
    input
        .parse()
        .map_err(|error| other_notation::within(&written).unwrap_or(error))
}

/// `=` after a word, with something behind it, or an error that says how to write it.
pub(crate) fn equals(word: &Ident, message: &str, input: ParseStream<'_>) -> syn::Result<()> {
    if !input.peek(Token![=]) {
        return Err(syn::Error::new(position(word, input), message));
    }
    let equals = input.parse::<Token![=]>()?;
    if ends(input) {
        return Err(syn::Error::new_spanned(equals, message));
    }
    Ok(())
}

/// What stands in parentheses after a word, and their span, or an error that says how to write it.
pub(crate) fn in_parentheses<'a>(
    word: &Ident,
    message: &str,
    input: ParseStream<'a>,
) -> syn::Result<(ParseBuffer<'a>, Span)> {
    if !input.peek(token::Paren) {
        return Err(syn::Error::new(position(word, input), message));
    }
    let content;
    let parentheses = syn::parenthesized!(content in input);
    Ok((content, parentheses.span.join()))
}

/// Notes a clause that may be written once; an error with this message if it is there already.
pub(crate) fn once<T>(
    clause: &mut Option<T>,
    found: T,
    span: Span,
    message: impl core::fmt::Display,
) -> syn::Result<()> {
    if clause.is_some() {
        return Err(syn::Error::new(span, message));
    }
    *clause = Some(found);
    Ok(())
}

/// A name, or an error that says what the name is for.
pub(crate) fn word(input: ParseStream<'_>, message: &str) -> syn::Result<Ident> {
    if input.peek(syn::Ident) || !input.peek(syn::Ident::peek_any) {
        return input
            .parse()
            .map_err(|error| syn::Error::new(error.span(), message));
    }
    let keyword = input.call(Ident::parse_any)?;
    let message = match keyword.to_string().as_str() {
        "self" | "Self" | "super" | "crate" | "_" => message.to_owned(),
        word => format!("`{word}` is a keyword of Rust: write `r#{word}`, or choose another name"),
    };
    Err(syn::Error::new(keyword.span(), message))
}

/// `(item, item, …)` after a keyword.
pub(crate) fn list(
    keyword: &Ident,
    input: ParseStream<'_>,
    separator: &str,
    read: impl FnMut(ParseStream<'_>) -> syn::Result<()>,
) -> syn::Result<()> {
    let message = match keyword.to_string().as_str() {
        "coordinates" => "write `coordinates(theta, phi)`".to_owned(),
        word => format!("write `{word}(name = expression, …)`"),
    };
    let (content, _) = in_parentheses(keyword, &message, input)?;
    separated(&content, separator, read)
}

/// Parses items that commas separate, up to the end. Where an item cannot be parsed, parsing resumes after the
/// next comma, so that all errors are reported together.
pub(crate) fn separated(
    input: ParseStream<'_>,
    separator: &str,
    mut read: impl FnMut(ParseStream<'_>) -> syn::Result<()>,
) -> syn::Result<()> {
    let mut errors: Option<syn::Error> = None;
    while !input.is_empty() {
        // What is read halfway is read again as mere tokens, which cannot fail.
        let item = input.fork();
        let result = read(&item).and_then(|()| {
            if ends(&item) {
                Ok(())
            } else {
                let instead = other_notation::behind(&item);
                Err(instead
                    .or_else(|| other_notation::within(input))
                    .unwrap_or_else(|| item.error(format!("write {separator} before this"))))
            }
        });
        match (result, &mut errors) {
            (Ok(()), _) => input.advance_to(&item),
            (Err(error), Some(errors)) => errors.combine(error),
            (Err(error), None) => errors = Some(error),
        }
        while !ends(input) {
            input.parse::<TokenTree>()?;
        }
        input.parse::<Option<Token![,]>>()?;
    }
    errors.map_or(Ok(()), Err)
}

/// Whether nothing follows in an item of a list.
pub(crate) fn ends(input: ParseStream<'_>) -> bool {
    input.is_empty() || input.peek(Token![,])
}

/// The span of an error about what follows `word`: there, or at the word if nothing follows.
pub(crate) fn position(word: &Ident, input: ParseStream<'_>) -> Span {
    if ends(input) {
        word.span()
    } else {
        input.span()
    }
}

/// The attributes of this derive.
pub(crate) fn own(attributes: &[Attribute]) -> impl Iterator<Item = &Attribute> {
    attributes
        .iter()
        .filter(|attribute| attribute.path().is_ident("lagrangian"))
}
