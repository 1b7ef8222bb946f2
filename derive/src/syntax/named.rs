//! Named expressions, in lists: `name = expression`, or `name[i] = expression for i in 0..5`.

use proc_macro2::{Ident, Literal, Span};
use syn::parse::ParseStream;
use syn::{Expr, Token, token};

use crate::syntax::grammar::{ends, equated, expression, list, word};
use crate::syntax::label::Index;

/// `name = expression` in a list, or `name[i] = expression for i in 0..5`.
#[derive(Clone)]
pub(crate) struct NamedExpression {
    pub(crate) name: Ident,
    pub(crate) indices: Vec<Expr>,
    pub(crate) expression: Expr,
    pub(crate) iterations: Vec<ForClause>,
}

/// `for index in range`.
#[derive(Clone)]
pub(crate) struct ForClause {
    pub(crate) index: Ident,
    pub(crate) range: Expr,
}

/// `(name = expression, …)` after a keyword.
pub(crate) fn named_expressions(
    keyword: &Ident,
    input: ParseStream<'_>,
    items: &mut Vec<NamedExpression>,
) -> syn::Result<()> {
    list(keyword, input, "a comma, or an operator,", |input| {
        items.push(NamedExpression::read(keyword, input)?);
        Ok(())
    })
}

impl NamedExpression {
    fn read(keyword: &Ident, input: ParseStream<'_>) -> syn::Result<Self> {
        let name = word(input, &format!("write `{keyword}(name = expression, …)`"))?;
        if keyword == "force" && name == "dot" && input.peek(token::Paren) {
            let message = "a force acts on a coordinate, or on a position or velocity that has a name in `define`: write \
                           `force(x = …)`";
            return Err(syn::Error::new(name.span(), message));
        }
        let mut indices = Vec::new();
        loop {
            if input.peek(Token![.]) && keyword == "force" {
                indices.push(axis(&name, input)?);
                continue;
            }
            if !input.peek(token::Bracket) {
                break;
            }
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
        let is_constraint = keyword == "constraint" || keyword == "nonholonomic";
        let expression = if is_constraint && !input.peek(Token![=]) {
            let message = format!(
                "a constraint has a name, by which its reaction is known: write `{keyword}(name = expression)` with an expression \
                 that is zero"
            );
            expression(&name, &message, input)?
        } else {
            equated(&name, input)?
        };
        let mut iterations = Vec::new();
        while let Some(word) = input.parse::<Option<Token![for]>>()? {
            iterations.push(ForClause::read(word, input)?);
        }
        Ok(Self {
            name,
            indices,
            expression,
            iterations,
        })
    }
}

/// `.x` behind the name of a vector on which a force acts, as the index that it stands for.
fn axis(name: &Ident, input: ParseStream<'_>) -> syn::Result<Expr> {
    let point: Token![.] = input.parse()?;
    let axis: Option<Ident> = input.parse()?;
    let position = axis
        .as_ref()
        .and_then(|axis| Index::AXES.iter().position(|name| axis == name));
    let Some(position) = position else {
        let message = format!("write `{name}.x`, `{name}.y` and so on for a component of a vector");
        return Err(match axis {
            Some(axis) => syn::Error::new(axis.span(), message),
            None => syn::Error::new(point.span, message),
        });
    };
    let span = axis.map_or(point.span, |axis| axis.span());
    let mut index = Literal::usize_unsuffixed(position);
    index.set_span(span);
    Ok(syn::parse_quote!(#index))
}

impl ForClause {
    /// `i in 0..5` behind `for`.
    fn read(keyword: Token![for], input: ParseStream<'_>) -> syn::Result<Self> {
        let message = "write `for i in 0..5`";
        let here = |input: ParseStream<'_>, before: Span| {
            syn::Error::new(if ends(input) { before } else { input.span() }, message)
        };
        let index: Ident = input.parse().map_err(|_| here(input, keyword.span))?;
        let between: Token![in] = input.parse().map_err(|_| here(input, index.span()))?;
        if ends(input) {
            return Err(here(input, between.span));
        }
        let range = input.parse()?;
        Ok(Self { index, range })
    }
}
