//! The size of a declaration, before it is parsed.
//!
//! Parsers of expressions recurse, and the stack of the compiler is finite: what would overflow it is refused. This is
//! a loop over the tokens.

use proc_macro2::{TokenStream, TokenTree, token_stream};

use crate::limits::{
    DEEPEST_GROUPS, MAX_EXPRESSION_LENGTH, MAX_METHOD_CALLS, MAX_OPERATORS_IN_ROW,
};

/// What has been read of an expression.
#[derive(Default)]
struct Length {
    tokens: usize,
    /// Dots: of method calls, fields and decimal fractions.
    calls: usize,
    /// Operators without an operand between them.
    operators: usize,
}

/// An error at the first token that is too deep or too far from the beginning of its expression.
pub(crate) fn check(tokens: TokenStream) -> syn::Result<()> {
    let mut groups: Vec<(token_stream::IntoIter, Length)> =
        vec![(tokens.into_iter(), Length::default())];
    while let Some((tokens, length)) = groups.last_mut() {
        let Some(token) = tokens.next() else {
            groups.pop();
            continue;
        };
        length.read(&token);
        if length.tokens > MAX_EXPRESSION_LENGTH {
            return Err(refusal(&token, TOO_LONG));
        }
        if length.calls > MAX_METHOD_CALLS || length.operators > MAX_OPERATORS_IN_ROW {
            return Err(refusal(&token, TOO_DEEP));
        }
        if let TokenTree::Group(group) = token {
            if groups.len() > DEEPEST_GROUPS {
                return Err(refusal(&TokenTree::Group(group), TOO_DEEP));
            }
            groups.push((group.stream().into_iter(), Length::default()));
        }
    }
    Ok(())
}

const TOO_LONG: &str = "this expression is too long: give parts of it names under `define`, or write a sum over a \
                        family as `(0..n).map(|i| …).sum()`";

const TOO_DEEP: &str =
    "this expression is nested too deeply: give parts of it names under `define`";

fn refusal(token: &TokenTree, message: &str) -> syn::Error {
    syn::Error::new(token.span(), message)
}

impl Length {
    fn read(&mut self, token: &TokenTree) {
        let TokenTree::Punct(punct) = token else {
            self.tokens += 1;
            self.operators = 0;
            return;
        };
        if matches!(punct.as_char(), ',' | ';') {
            *self = Self::default();
            return;
        }
        self.tokens += 1;
        self.operators += 1;
        if punct.as_char() == '.' {
            self.calls += 1;
        }
    }
}
