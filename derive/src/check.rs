//! Checks of a declaration before its expressions are lowered.
//!
//! The reason for each check is the message that it reports.

mod fields;
mod functions;
mod c;
mod reflect;
mod names;
mod parameter_lists;
mod scalar;

use std::collections::BTreeSet;

use proc_macro2::Ident;

use crate::diagnostics::{Diagnostics, similar};
use crate::plan::is_method;
use crate::syntax::clauses::Clause;
use crate::syntax::declaration::Declaration;
use crate::syntax::names::unraw;

/// Checks names, types of fields and the set of clauses.
pub(crate) fn check(declaration: &Declaration, diagnostics: &mut Diagnostics) {
    fields::check_field_types(declaration, diagnostics);
    fields::check_coordinate_types(declaration, diagnostics);
    scalar::check(declaration, diagnostics);
    names::check_names(declaration, diagnostics);
    functions::check(declaration, diagnostics);
    names::check_constants(declaration, diagnostics);
    check_forces(declaration, diagnostics);
    check_outputs(declaration, diagnostics);
    check_events(declaration, diagnostics);
    check_constraints(declaration, diagnostics);
    check_clauses_beside_constraints(declaration, diagnostics);
    parameter_lists::check(declaration, diagnostics);
    check_gravity(declaration, diagnostics);
    c::check(declaration, diagnostics);
    reflect::check(declaration, diagnostics);
    check_reduced_name(declaration, diagnostics);
    if !declaration.clauses.unreadable {
        check_energies(declaration, diagnostics);
    }
}

/// Models with constraints do not have what some clauses need.
fn check_clauses_beside_constraints(declaration: &Declaration, diagnostics: &mut Diagnostics) {
    let clauses = &declaration.clauses;
    if clauses.constraints.is_empty() && clauses.nonholonomic.is_empty() {
        return;
    }
    if let Some(keyword) = &clauses.hamiltonian {
        let message = "a model with constraints has no canonical equations: leave `hamiltonian` out; momenta are \
                       `model.momenta(&state)`";
        diagnostics.error(keyword, message);
    }
}

/// Forces act on coordinates and on what is defined by them. That none of a clause acts twice on the same
/// coordinate shows when indices are known.
fn check_forces(declaration: &Declaration, diagnostics: &mut Diagnostics) {
    let clauses = &declaration.clauses;
    if clauses.names_unreadable || clauses.coordinates.is_empty() {
        return;
    }
    let coordinates = clauses.coordinates.iter();
    let coordinates = coordinates.map(|coordinate| unraw(&coordinate.name));
    let definitions = clauses.definitions.iter();
    let definitions = definitions.map(|definition| unraw(&definition.name));
    let coordinates: BTreeSet<String> = coordinates.collect();
    let names: BTreeSet<String> = coordinates.iter().cloned().chain(definitions).collect();
    for force in clauses.forces.iter().flatten() {
        let written = unraw(&force.name);
        if !names.contains(&written) {
            let meant = similar(&written, names.iter().map(String::as_str));
            let hint = meant.map_or_else(
                || {
                    let coordinates: Vec<_> = coordinates.iter().map(String::as_str).collect();
                    format!("write one of `{}`", coordinates.join("`, `"))
                },
                |meant| format!("did you mean `{meant}`?"),
            );
            let message = format!(
                "a force acts on a coordinate or on a position that is defined, and `{written}` is neither: {hint}"
            );
            diagnostics.error(&force.name, message);
        }
    }
}

/// The name of the reduced model is that of no other struct.
fn check_reduced_name(declaration: &Declaration, diagnostics: &mut Diagnostics) {
    let Some(clause) = &declaration.clauses.routhian else {
        return;
    };
    let (name, written) = (unraw(&declaration.name), unraw(&clause.name));
    let has_outputs = !declaration.clauses.outputs.is_empty();
    let is_outputs = has_outputs && written == format!("{name}Outputs");
    let has_such_outputs = has_outputs && name == format!("{written}Outputs");
    if written == name || is_outputs || has_such_outputs {
        let holder = if is_outputs {
            "the struct of the outputs"
        } else if has_such_outputs {
            "the name of a model whose outputs would be this model"
        } else {
            "the model itself"
        };
        let message = format!(
            "`{written}` is {holder}: give the reduced model a name of its own, such as `Reduced{name}`"
        );
        diagnostics.error(&clause.name, message);
    }
}

fn check_outputs(declaration: &Declaration, diagnostics: &mut Diagnostics) {
    let mut seen = BTreeSet::new();
    for output in &declaration.clauses.outputs {
        if !seen.insert(unraw(&output.name)) {
            declared_twice("output", &output.name, diagnostics);
        } else if is_method(&output.name.to_string()) {
            let message = format!(
                "`{0}` is a method of every model: give the output another name, such as `{0}_shown`",
                output.name
            );
            diagnostics.error(&output.name, message);
        }
        if !output.indices.is_empty() || !output.iterations.is_empty() {
            let message = format!(
                "an output is one quantity, which may be a vector: write \
                 `{} = (0..5).map(|i| …).collect()`",
                output.name
            );
            diagnostics.error(&output.name, message);
        }
    }
}

fn check_events(declaration: &Declaration, diagnostics: &mut Diagnostics) {
    let mut seen = BTreeSet::new();
    for event in &declaration.clauses.events {
        if !seen.insert(unraw(&event.name)) {
            declared_twice("event", &event.name, diagnostics);
        }
        if !event.indices.is_empty() || !event.iterations.is_empty() {
            let message = format!(
                "several events of one name are a vector: write `{} = (0..5).map(|i| …).collect()`",
                event.name
            );
            diagnostics.error(&event.name, message);
        }
    }
}

fn declared_twice(kind: &str, name: &Ident, diagnostics: &mut Diagnostics) {
    let message = format!("the {kind} `{name}` is declared twice: give one of them another name");
    diagnostics.error(name, message);
}

/// Constraints of both kinds have names of their own.
fn check_constraints(declaration: &Declaration, diagnostics: &mut Diagnostics) {
    let clauses = &declaration.clauses;
    let (mut seen, mut families) = (BTreeSet::new(), BTreeSet::new());
    for (is_holonomic, constraints) in
        [(true, &clauses.constraints), (false, &clauses.nonholonomic)]
    {
        for constraint in constraints {
            let name = unraw(&constraint.name);
            let is_member = !constraint.indices.is_empty();
            let member = is_member.then(|| (name.clone(), is_holonomic));
            let is_known = member.is_some_and(|member| !families.insert(member));
            if !is_known && !seen.insert(name) {
                declared_twice("constraint", &constraint.name, diagnostics);
            }
        }
    }
}

/// Gravity is that of the bodies.
fn check_gravity(declaration: &Declaration, diagnostics: &mut Diagnostics) {
    let clauses = &declaration.clauses;
    if let (Some(gravity), true) = (
        &clauses.gravity,
        clauses.bodies.is_empty() && !clauses.unreadable,
    ) {
        let message = "gravity acts on the bodies of `body(…)`, and there is none: write `body(link = (r, p))`, or the \
                       weight under `potential`";
        diagnostics.error(&gravity.keyword, message);
    }
}

/// A Lagrangian is given once, as such or by its energies.
fn check_energies(declaration: &Declaration, diagnostics: &mut Diagnostics) {
    let clauses = &declaration.clauses;
    if let [_, second, ..] = clauses.lagrangian.as_slice() {
        diagnostics.error(
            &second.keyword,
            "there is a Lagrangian already: add them up in one expression",
        );
    }
    let energy = clauses.kinetic.first().or(clauses.potential.first());
    if let (Some(lagrangian), Some(energy)) = (clauses.lagrangian.first(), energy) {
        diagnostics.error(
            &lagrangian.keyword,
            format!(
                "`lagrangian` stands in place of `kinetic` and `potential`: remove it, or `{}`",
                energy.keyword
            ),
        );
    }
}

/// Checks that nothing is missing. It is not reported beside other errors: a declaration that is being typed is
/// incomplete.
pub(crate) fn check_whole(declaration: &Declaration, diagnostics: &mut Diagnostics) {
    let clauses = &declaration.clauses;
    let name = &declaration.name;
    if clauses.coordinates.is_empty() {
        let message = "no coordinates: write `#[lagrangian(coordinates(theta), kinetic = …)]`";
        diagnostics.error(name, message);
    } else if clauses.lagrangian.is_empty() && clauses.kinetic.is_empty() {
        let potential = clauses.potential.first();
        diagnostics.error(
            potential.map_or(name, |potential: &Clause| &potential.keyword),
            "no kinetic energy: write `kinetic = 0.5 * m * dot(x).powi(2)`, or a whole `lagrangian = …`",
        );
    }
}
