//! Clauses of one word, and clauses about parameters: `regressor` alone is about all of them, `regressor(m, l)` about
//! some.

use proc_macro2::Ident;
use syn::parse::ParseStream;
use syn::{Token, token};

use crate::syntax::grammar::{ends, in_parentheses, once, separated, word};

/// A word, and the fields that it is about.
#[derive(Clone)]
pub(crate) struct ParameterList {
    pub(crate) keyword: Ident,
    /// Their names; none where it is about all parameters.
    pub(crate) fields: Option<Vec<Ident>>,
}

impl ParameterList {
    /// Parses what follows the keyword.
    pub(crate) fn read(
        keyword: Ident,
        input: ParseStream<'_>,
        list: &mut Option<Self>,
    ) -> syn::Result<()> {
        if list.is_some() {
            let message = format!("there is a `{keyword}` already: name all parameters in one");
            return Err(syn::Error::new(keyword.span(), message));
        }
        let how = format!(
            "write `{keyword}` alone, for all parameters, or with the names of some, as in `{keyword}(m, inertia)`"
        );
        if ends(input) {
            *list = Some(Self {
                keyword,
                fields: None,
            });
            return Ok(());
        }
        let (content, span) = in_parentheses(&keyword, &how, input)?;
        if content.is_empty() {
            return Err(syn::Error::new(span, how));
        }
        let mut fields = Vec::new();
        let read = separated(&content, "a comma", |input| {
            let field = word(input, &how)?;
            if input.peek(token::Bracket) || input.peek(Token![.]) {
                let message = format!("write `{field}` alone: it stands for all its components");
                return Err(syn::Error::new(input.span(), message));
            }
            fields.push(field);
            Ok(())
        });
        *list = Some(Self {
            keyword,
            fields: Some(fields),
        });
        read
    }
}

/// Notes a clause that is a word alone, of which there is one.
pub(crate) fn word_alone(
    keyword: Ident,
    input: ParseStream<'_>,
    clause: &mut Option<Ident>,
) -> syn::Result<()> {
    if !ends(input) {
        let message = format!("write `{keyword}` alone, and a comma behind it");
        return Err(syn::Error::new(input.span(), message));
    }
    let message = format!("there is a `{keyword}` already: keep one");
    let span = keyword.span();
    once(clause, keyword, span, message)
}
