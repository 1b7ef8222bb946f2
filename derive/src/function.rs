//! Functions from outside: `function(name(argument, …) = value, derivative(argument) = expression, …)`.
//!
//! The value is any expression of Rust; what the derivatives are made of is of the declaration language.

use std::collections::{BTreeMap, BTreeSet};

use proc_macro2::{Ident, Span};
use syn::parse::ParseStream;
use syn::{Expr, token};

use crate::check::refuse_reserved;
use crate::declaration::Declaration;
use crate::diagnostics::{Diagnostics, similar};
use crate::field::Role;
use crate::grammar::{expression, position, separated, word};
use crate::hints;
use crate::names::plain;
use crate::scope::RESERVED;

/// A function from outside.
pub(crate) struct Function {
    pub(crate) name: Ident,
    pub(crate) arguments: Vec<Ident>,
    /// The value, for the compiler to understand.
    pub(crate) value: Expr,
    pub(crate) derivatives: Vec<Derivative>,
}

/// `derivative(argument) = expression`.
pub(crate) struct Derivative {
    pub(crate) argument: Ident,
    pub(crate) expression: Expr,
}

impl Function {
    /// Reads what stands behind the keyword, and keeps what could be read even where there is an error.
    pub(crate) fn read(
        keyword: &Ident,
        input: ParseStream<'_>,
        functions: &mut Vec<Self>,
    ) -> syn::Result<()> {
        if !input.peek(token::Paren) {
            return Err(syn::Error::new(position(keyword, input), HOW_TO_DECLARE));
        }
        let content;
        let parentheses = syn::parenthesized!(content in input);
        if content.is_empty() {
            return Err(syn::Error::new(parentheses.span.join(), HOW_TO_DECLARE));
        }
        let mut function = None;
        let mut derivatives = Vec::new();
        let read = separated(&content, "a comma, or an operator,", |input| {
            if function.is_some() {
                derivatives.push(Derivative::read(input)?);
            } else {
                // What comes after a head that cannot be read is not looked at.
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

impl Derivative {
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

/// `(name, …)` behind a word, and where that stands.
fn names(before: &Ident, input: ParseStream<'_>, message: &str) -> syn::Result<(Vec<Ident>, Span)> {
    if !input.peek(token::Paren) {
        let message = format!("write `{before}(x) = …`");
        return Err(syn::Error::new(position(before, input), message));
    }
    let content;
    let parentheses = syn::parenthesized!(content in input);
    let mut names = Vec::new();
    separated(&content, "a comma", |input| {
        names.push(word(input, message)?);
        Ok(())
    })?;
    Ok((names, parentheses.span.join()))
}

const HOW_TO_DECLARE: &str =
    "write `function(f(x) = value, derivative(x) = …)`, where `value` is an expression of Rust";

const HOW_TO_DIFFERENTIATE: &str =
    "write `derivative(x) = …`, with one of the function's arguments";

/// Checks the names of functions and of their arguments, and what their derivatives are by.
pub(crate) fn check(declaration: &Declaration, diagnostics: &mut Diagnostics) {
    let mut taken = quantities(declaration);
    for function in &declaration.clauses.functions {
        let name = &function.name;
        if RESERVED.iter().any(|reserved| name == reserved) {
            refuse_reserved(name, diagnostics);
        } else if hints::is_function(&plain(name)) {
            let message = format!(
                "`{name}` is a function of the declaration language: give this one another name"
            );
            diagnostics.error(name, message);
        } else if let Some(holder) = taken.insert(plain(name), "function") {
            let message = match holder {
                "function" => format!("`{name}` is declared twice: give one of them another name"),
                _ => format!("`{name}` is a {holder} already: give this function another name"),
            };
            diagnostics.error(name, message);
        }
        check_arguments(declaration, function, diagnostics);
        check_derivatives(function, diagnostics);
    }
}

/// The names that stand for quantities. A skipped field may be called as the function that reads it, and
/// an output as what it shows.
fn quantities(declaration: &Declaration) -> BTreeMap<String, &'static str> {
    let clauses = &declaration.clauses;
    let fields = declaration.fields.iter();
    let fields = fields.filter(|field| field.role != Role::Skipped);
    let fields = fields.map(|field| (&field.name, "field"));
    let coordinates = clauses.coordinates.iter();
    let coordinates = coordinates.map(|coordinate| (&coordinate.name, "coordinate"));
    let definitions = clauses.definitions.iter();
    let definitions = definitions.map(|definition| (&definition.name, "definition"));
    let all = fields.chain(coordinates).chain(definitions);
    all.map(|(name, kind)| (plain(name), kind)).collect()
}

fn check_arguments(declaration: &Declaration, function: &Function, diagnostics: &mut Diagnostics) {
    let mut seen = BTreeSet::new();
    for argument in &function.arguments {
        refuse_reserved(argument, diagnostics);
        let mut fields = declaration.fields.iter();
        if !seen.insert(plain(argument)) {
            let message =
                format!("`{argument}` is an argument already: give one of them another name");
            diagnostics.error(argument, message);
        } else if fields
            .any(|field| field.role != Role::Skipped && plain(&field.name) == plain(argument))
        {
            let message =
                format!("`{argument}` is a field already: give this argument another name");
            diagnostics.error(argument, message);
        }
    }
}

fn check_derivatives(function: &Function, diagnostics: &mut Diagnostics) {
    let mut seen = BTreeSet::new();
    for Derivative { argument, .. } in &function.derivatives {
        let written = plain(argument);
        let arguments: Vec<String> = function.arguments.iter().map(plain).collect();
        if !arguments.contains(&written) {
            let name = &function.name;
            let hint = match (
                similar(&written, arguments.iter().map(String::as_str)),
                &*arguments,
            ) {
                (Some(meant), _) => format!("did you mean `{meant}`?"),
                (None, []) => "it has none".to_owned(),
                (None, _) => format!("write one of `{}`", arguments.join("`, `")),
            };
            let message = format!("`{argument}` is no argument of `{name}`: {hint}");
            diagnostics.error(argument, message);
        } else if !seen.insert(written) {
            let message =
                format!("the derivative by `{argument}` is given twice: keep one of them");
            diagnostics.error(argument, message);
        }
    }
}
