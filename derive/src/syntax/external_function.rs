//! External functions: `function(name(argument, …) = value, derivative(argument) = expression, …)`.
//!
//! The value is any expression of Rust; the derivatives are expressions of the declaration language.

use proc_macro2::{Ident, Span};
use syn::Expr;
use syn::parse::ParseStream;

use crate::syntax::grammar::{expression, in_parentheses, separated, word};

/// An external function.
#[derive(Clone)]
pub(crate) struct FunctionDeclaration {
    pub(crate) name: Ident,
    pub(crate) arguments: Vec<Ident>,
    /// The value: an expression of Rust.
    pub(crate) value: Expr,
    pub(crate) derivatives: Vec<DerivativeDeclaration>,
}

/// `derivative(argument) = expression`.
#[derive(Clone)]
pub(crate) struct DerivativeDeclaration {
    pub(crate) argument: Ident,
    pub(crate) expression: Expr,
}

impl FunctionDeclaration {
    /// Parses what follows the keyword, with recovery: what can be parsed is kept.
    pub(crate) fn read(
        keyword: &Ident,
        input: ParseStream<'_>,
        functions: &mut Vec<Self>,
    ) -> syn::Result<()> {
        let (content, span) = in_parentheses(keyword, HOW_TO_DECLARE, input)?;
        if content.is_empty() {
            return Err(syn::Error::new(span, HOW_TO_DECLARE));
        }
        let mut function = None;
        let mut derivatives = Vec::new();
        let read = separated(&content, "a comma, or an operator,", |input| {
            if function.is_some() {
                derivatives.push(DerivativeDeclaration::read(input)?);
            } else {
                // After a head that cannot be parsed nothing is.
                function = Some(None);
                function = Some(Some(Self::head(input)?));
            }
            Ok(())
        });
        if let Some(Some(function)) = function {
            functions.push(Self {
                derivatives,
                ..function
            });
        }
        read
    }

    /// `name(argument, …) = value`.
    fn head(input: ParseStream<'_>) -> syn::Result<Self> {
        let name = word(input, HOW_TO_DECLARE)?;
        let (arguments, _) = names(&name, input, "the arguments of a function are names")?;
        let written: Vec<String> = arguments.iter().map(ToString::to_string).collect();
        let message = format!(
            "write `{name}({}) = value`, where `value` is an expression of Rust",
            written.join(", ")
        );
        Ok(Self {
            value: expression(&name, &message, input)?,
            name,
            arguments,
            derivatives: Vec::new(),
        })
    }
}

impl DerivativeDeclaration {
    fn read(input: ParseStream<'_>) -> syn::Result<Self> {
        let keyword = word(input, HOW_TO_DIFFERENTIATE)?;
        if keyword != "derivative" {
            return Err(syn::Error::new(keyword.span(), HOW_TO_DIFFERENTIATE));
        }
        let (arguments, span) = names(&keyword, input, HOW_TO_DIFFERENTIATE)?;
        let mut arguments = arguments.into_iter();
        match (arguments.next(), arguments.next()) {
            (Some(argument), None) => Ok(Self {
                expression: expression(
                    &keyword,
                    &format!("write `derivative({argument}) = expression`"),
                    input,
                )?,
                argument,
            }),
            _ => Err(syn::Error::new(
                span,
                "a derivative is by one argument: write `derivative(x) = …` for each",
            )),
        }
    }
}

/// `(name, …)` after a word, and its span.
fn names(before: &Ident, input: ParseStream<'_>, message: &str) -> syn::Result<(Vec<Ident>, Span)> {
    let (content, span) = in_parentheses(before, &format!("write `{before}(x) = …`"), input)?;
    let mut names = Vec::new();
    separated(&content, "a comma", |input| {
        names.push(word(input, message)?);
        Ok(())
    })?;
    Ok((names, span))
}

const HOW_TO_DECLARE: &str =
    "write `function(f(x) = value, derivative(x) = …)`, where `value` is an expression of Rust";

const HOW_TO_DIFFERENTIATE: &str =
    "write `derivative(x) = …`, with one of the function's arguments";
