//! Checks of the names of fields, coordinates and definitions.

use std::collections::{BTreeMap, BTreeSet};

use proc_macro2::Ident;

use crate::diagnostics::Diagnostics;
use crate::plan::constants::{
    CONSTANTS, CONSTANTS_OF_C, CONSTANTS_OF_CONSERVATION, CONSTANTS_OF_CONSTRAINTS,
    CONSTANTS_OF_EVENTS, CONSTANTS_OF_FUNCTIONS, CONSTANTS_OF_INPUTS, CONSTANTS_OF_REDUCED_MODELS,
    CONSTANTS_OF_REGRESSORS, CONSTANTS_OF_SENSITIVITIES, CONSTANTS_OF_SYSTEMS,
};
use crate::syntax::declaration::Declaration;
use crate::syntax::field::Role;
use crate::syntax::named::NamedExpression;
use crate::syntax::names::{RESERVED, constant_name, unraw};

/// Names are unique, and none is reserved.
pub(super) fn check_names(declaration: &Declaration, diagnostics: &mut Diagnostics) {
    let mut taken: BTreeMap<String, &str> = BTreeMap::new();
    for field in &declaration.fields {
        if field.role != Role::Skipped {
            refuse_reserved(&field.name, diagnostics);
        }
        taken.insert(unraw(&field.name), "field");
    }
    let clauses = &declaration.clauses;
    let coordinates = clauses.coordinates.iter();
    let coordinates = coordinates.map(|coordinate| (&coordinate.name, "coordinate"));
    let definitions = first_of_families(&clauses.definitions)
        .into_iter()
        .map(|name| (name, "definition"));
    for (name, kind) in coordinates.chain(definitions) {
        refuse_reserved(name, diagnostics);
        if let Some(holder) = taken.insert(unraw(name), kind) {
            let message = if holder == kind {
                format!("`{name}` is declared twice: give one of them another name")
            } else {
                format!("`{name}` is a {holder} already: give this {kind} another name")
            };
            diagnostics.error(name, message);
        }
    }
}

/// The names of definitions; that of a family once, though its members may be defined one by one.
fn first_of_families(definitions: &[NamedExpression]) -> Vec<&Ident> {
    let mut families = BTreeSet::new();
    let first =
        |named: &&NamedExpression| named.indices.is_empty() || families.insert(unraw(&named.name));
    definitions
        .iter()
        .filter(first)
        .map(|named| &named.name)
        .collect()
}

pub(super) fn refuse_reserved(name: &Ident, diagnostics: &mut Diagnostics) {
    if RESERVED.iter().any(|reserved| name == reserved) {
        let binding = match name.to_string().as_str() {
            "t" => "the time",
            "PI" => "the number π",
            _ => "the time derivative",
        };
        diagnostics.error(name, format!("`{name}` is {binding}: choose another name"));
    }
}

/// Each coordinate, each input, each event and each constraint becomes a constant of the type, beside those that are always there.
pub(super) fn check_constants(declaration: &Declaration, diagnostics: &mut Diagnostics) {
    let mut taken = constants(declaration);
    let clauses = &declaration.clauses;
    let coordinates = clauses.coordinates.iter();
    let coordinates = coordinates.map(|coordinate| (&coordinate.name, "coordinate"));
    let inputs = declaration.fields_with(Role::Input);
    let inputs = inputs.map(|field| (&field.name, "input"));
    let events = clauses.events.iter();
    let events = events.map(|event| (&event.name, "event"));
    let constraints = [&clauses.constraints, &clauses.nonholonomic];
    let constraints = constraints
        .into_iter()
        .flat_map(|all| first_of_families(all));
    let constraints = constraints.map(|name| (name, "constraint"));
    let named = coordinates.chain(inputs).chain(events).chain(constraints);
    for (name, quantity) in named {
        let constant = constant_name(name);
        let kind = match quantity {
            "event" | "constraint" => format!("the index of the {quantity} `{name}`"),
            _ => format!("the index of `{name}`"),
        };
        // The same name twice is reported as such.
        if let Some(holder) = taken.insert(constant.clone(), kind.clone())
            && holder != kind
        {
            let message = format!(
                "this {quantity}'s index is the constant `{constant}`, which is {holder}: rename the {quantity}"
            );
            diagnostics.error(name, message);
        }
    }
}

/// The constants that a model has, with what they are constants of.
fn constants(declaration: &Declaration) -> BTreeMap<String, String> {
    let clauses = &declaration.clauses;
    let has_inputs = declaration.fields_with(Role::Input).next().is_some();
    let has_functions = !clauses.functions.is_empty();
    let has_events = !clauses.events.is_empty();
    let has_constraints = !clauses.constraints.is_empty() || !clauses.nonholonomic.is_empty();
    let every = "a constant of every model";
    let all: [(&[&str], bool, &str); 11] = [
        (&CONSTANTS, true, every),
        (&CONSTANTS_OF_SYSTEMS, true, every),
        (
            &CONSTANTS_OF_CONSERVATION,
            true,
            "a constant of every model with constants of motion",
        ),
        (
            &CONSTANTS_OF_REDUCED_MODELS,
            clauses.routhian.is_some(),
            "a constant of every reduced model",
        ),
        (
            &CONSTANTS_OF_INPUTS,
            has_inputs,
            "a constant of every model with inputs",
        ),
        (
            &CONSTANTS_OF_FUNCTIONS,
            has_functions,
            "a constant of every model with external functions",
        ),
        (
            &CONSTANTS_OF_EVENTS,
            has_events,
            "a constant of every model with events",
        ),
        (
            &CONSTANTS_OF_CONSTRAINTS,
            has_constraints,
            "a constant of every model with constraints",
        ),
        (
            &CONSTANTS_OF_SENSITIVITIES,
            declaration.clauses.sensitivities.is_some(),
            "a constant of every model with `sensitivities`",
        ),
        (
            &CONSTANTS_OF_REGRESSORS,
            declaration.clauses.regressor.is_some(),
            "a constant of every model with a `regressor`",
        ),
        (
            &CONSTANTS_OF_C,
            clauses.c.is_some(),
            "a constant of every model with `c`",
        ),
    ];
    let all = all.into_iter().filter(|(_, there, _)| *there);
    all.flat_map(|(names, _, holder)| {
        let names = names.iter();
        names.map(move |name| ((*name).to_owned(), holder.to_owned()))
    })
    .collect()
}
