//! Checks of the names of external functions, of their arguments, and of their derivatives.

use std::collections::{BTreeMap, BTreeSet};

use super::names::refuse_reserved;
use crate::diagnostics::{Diagnostics, hint};
use crate::lower::builtins;
use crate::syntax::declaration::Declaration;
use crate::syntax::external_function::{DerivativeDeclaration, FunctionDeclaration};
use crate::syntax::field::Role;
use crate::syntax::names::{RESERVED, unraw};

/// Checks the names of functions and of their arguments, and by which arguments they are differentiated.
pub(super) fn check(declaration: &Declaration, diagnostics: &mut Diagnostics) {
    let mut taken = quantities(declaration);
    for function in &declaration.clauses.functions {
        let name = &function.name;
        if RESERVED.iter().any(|reserved| name == reserved) {
            refuse_reserved(name, diagnostics);
        } else if builtins::is_reserved(&unraw(name)) {
            let message = format!(
                "`{name}` is a function of the declaration language: give this one another name"
            );
            diagnostics.error(name, message);
        } else if let Some(holder) = taken.insert(unraw(name), "function") {
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

/// The names of quantities. A skipped field may be called like the function that reads it, and an output like
/// what it shows.
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
    all.map(|(name, kind)| (unraw(name), kind)).collect()
}

fn check_arguments(
    declaration: &Declaration,
    function: &FunctionDeclaration,
    diagnostics: &mut Diagnostics,
) {
    let mut seen = BTreeSet::new();
    for argument in &function.arguments {
        refuse_reserved(argument, diagnostics);
        let mut fields = declaration.fields.iter();
        if !seen.insert(unraw(argument)) {
            let message =
                format!("`{argument}` is an argument already: give one of them another name");
            diagnostics.error(argument, message);
        } else if fields
            .any(|field| field.role != Role::Skipped && unraw(&field.name) == unraw(argument))
        {
            let message =
                format!("`{argument}` is a field already: give this argument another name");
            diagnostics.error(argument, message);
        }
    }
}

fn check_derivatives(function: &FunctionDeclaration, diagnostics: &mut Diagnostics) {
    let mut seen = BTreeSet::new();
    for DerivativeDeclaration { argument, .. } in &function.derivatives {
        let written = unraw(argument);
        let arguments: Vec<String> = function.arguments.iter().map(unraw).collect();
        if !arguments.contains(&written) {
            let name = &function.name;
            let hint = match &*arguments {
                [] => "it has none".to_owned(),
                _ => hint(&written, &arguments, "one"),
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
