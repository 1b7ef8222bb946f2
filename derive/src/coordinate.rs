//! The coordinates of a declaration, one by one or in families.

use proc_macro2::Ident;
use syn::parse::ParseStream;
use syn::{LitInt, Token, token};

use crate::grammar::{list, word};

/// A generalized coordinate, or several under one name.
pub(crate) struct Coordinate {
    pub(crate) name: Ident,
    /// How many there are of a family, `theta[5]`.
    pub(crate) length: Option<usize>,
}

/// `(name, name, …)` after the keyword.
pub(crate) fn coordinates(
    keyword: &Ident,
    input: ParseStream<'_>,
    names: &mut Vec<Coordinate>,
) -> syn::Result<()> {
    list(keyword, input, "a comma between coordinates", |input| {
        names.push(coordinate(input)?);
        Ok(())
    })
}

fn coordinate(input: ParseStream<'_>) -> syn::Result<Coordinate> {
    let name = word(
        input,
        "coordinates are names: write `coordinates(theta, phi)`",
    )?;
    let length = if input.peek(token::Bracket) {
        Some(family_length(&name, input)?)
    } else {
        None
    };
    if input.peek(Token![:]) {
        return Err(input.error("coordinates have no types: write the name alone"));
    }
    Ok(Coordinate { name, length })
}

/// How many coordinates a family may have.
const LARGEST_FAMILY: usize = 1000;

/// `[5]` behind the name of a family of coordinates.
fn family_length(name: &Ident, input: ParseStream<'_>) -> syn::Result<usize> {
    let content;
    let bracket = syn::bracketed!(content in input);
    let message =
        format!("the size of a family is a number from 1 to {LARGEST_FAMILY}: write `{name}[5]`");
    let length: LitInt = content.parse().map_err(|error| {
        let span = if content.is_empty() {
            bracket.span.join()
        } else {
            error.span()
        };
        syn::Error::new(span, &message)
    })?;
    if !content.is_empty() {
        return Err(content.error(message));
    }
    match length.base10_parse() {
        Ok(number @ 1..=LARGEST_FAMILY) if length.suffix().is_empty() => Ok(number),
        _ => Err(syn::Error::new(length.span(), message)),
    }
}
