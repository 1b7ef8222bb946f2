//! Checks of the names of fields, coordinates and definitions.

use std::collections::{BTreeMap, BTreeSet};

use proc_macro2::Ident;

use crate::diagnostics::Diagnostics;
use crate::plan::constants::constants;
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
    let constants = constants(declaration);
    let constants =
        constants.map(|(name, kind)| (name.to_owned(), format!("a constant of every {kind}")));
    let mut taken: BTreeMap<String, String> = constants.collect();
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
