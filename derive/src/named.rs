//! Expressions under names, in lists: `name = expression`, or `name[i] = expression for i in 0..5`.

use proc_macro2::{Ident, Span};
use syn::parse::ParseStream;
use syn::{Expr, Token, token};

use crate::grammar::{equated, list, word};

/// `name = expression` in a list, or `name[i] = expression for i in 0..5`.
pub(crate) struct Named {
    pub(crate) name: Ident,
    pub(crate) indices: Vec<Expr>,
    pub(crate) expression: Expr,
    pub(crate) iterations: Vec<Iteration>,
}

/// `for index in range`.
pub(crate) struct Iteration {
    pub(crate) index: Ident,
    pub(crate) range: Expr,
}

/// `(name = expression, …)` after a keyword.
pub(crate) fn named(
    keyword: &Ident,
    input: ParseStream<'_>,
    items: &mut Vec<Named>,
) -> syn::Result<()> {
    list(keyword, input, "a comma, or an operator,", |input| {
        items.push(Named::read(keyword, input)?);
        Ok(())
    })
}

impl Named {
    fn read(keyword: &Ident, input: ParseStream<'_>) -> syn::Result<Self> {
        let name = word(input, &format!("write `{keyword}(name = expression, …)`"))?;
        let mut indices = Vec::new();
        while input.peek(token::Bracket) {
            let content;
            let bracket = syn::bracketed!(content in input);
            let message =
                format!("write one index in brackets, as in `{name}[i] = … for i in 0..5`");
            if content.is_empty() {
                return Err(syn::Error::new(bracket.span.join(), message));
            }
            indices.push(content.parse()?);
            if !content.is_empty() {
                return Err(content.error(message));
            }
        }
        let expression = equated(&name, input)?;
        let mut iterations = Vec::new();
        while let Some(word) = input.parse::<Option<Token![for]>>()? {
            iterations.push(Iteration::read(word, input)?);
        }
        Ok(Self {
            name,
            indices,
            expression,
            iterations,
        })
    }
}

impl Iteration {
    /// `i in 0..5` behind `for`.
    fn read(keyword: Token![for], input: ParseStream<'_>) -> syn::Result<Self> {
        let message = "write `for i in 0..5`";
        let here = |input: ParseStream<'_>, before: Span| {
            let nothing = input.is_empty() || input.peek(Token![,]);
            syn::Error::new(if nothing { before } else { input.span() }, message)
        };
        let index: Ident = input.parse().map_err(|_| here(input, keyword.span))?;
        let between: Token![in] = input.parse().map_err(|_| here(input, index.span()))?;
        if input.is_empty() || input.peek(Token![,]) {
            return Err(here(input, between.span));
        }
        let range = input.parse()?;
        Ok(Self { index, range })
    }
}
