//! The documentation of the emitted impl: the equations as they were derived, and the operation counts.

use std::collections::BTreeSet;
use std::fmt::Write as _;

use lagrangian_symbolic::{
    Declared, Equations, Expression, Graph, Listing, Model, Node, SolvedForm, Symbol,
};

use super::as_declared::as_declared;
use super::emitter::Emitter;
use super::events::names;
use super::printed_names::{BodyNames, defined, printed_names};
use crate::lower::Lowered;
use crate::plan::{Columns, MethodOutputs};
use crate::syntax::declaration::Declaration;
use crate::syntax::names::unraw;

/// The documentation of the model's impl: coordinates, energies, mass matrix, equations of motion.
pub(crate) fn of(emitter: &Emitter<'_>, equations: &str) -> String {
    let mut text = String::from(
        "# The equations of motion\n\nd/dt (∂L/∂q̇) − ∂L/∂q = Q (4.6), with\n\n```text\n",
    );
    text.push_str(equations);
    text.push_str("```\n");
    text.push_str(&emitter.constraints_in_words());
    text.push_str("\n# Operations\n\n");
    text.push_str(
        "| method | + − | × | ÷ | √ | sin, cos | others |\n|---|---|---|---|---|---|---|\n",
    );
    for (name, method) in emitter.methods.counted() {
        let count = method.map(|method| method.count).unwrap_or_default();
        let counts = count.by_kind().map(|number| number.to_string()).join(" | ");
        // Writing to a `String` does not fail.
        let _ = writeln!(text, "| `{name}` | {counts} |");
    }
    for (name, method) in emitter.methods.counted() {
        if let Some(MethodOutputs::ByColumns(columns)) = method.map(|method| &method.outputs) {
            let _ = writeln!(
                text,
                "\n`{name}` is computed column by column: {}.",
                way(*columns)
            );
        }
    }
    text
}

/// How columns are computed.
const fn way(columns: Columns) -> &'static str {
    match columns {
        Columns::MassMatrix => "the momenta at unit velocities, less those at rest",
        Columns::Linearization => {
            "M δq̈ = −δ(M q̈ − f), with `inverse_dynamics` on dual numbers, and M factored numerically"
        }
        Columns::InputJacobian => {
            "M δq̈ = δQ, with `inverse_dynamics` on dual numbers, and M factored numerically"
        }
    }
}

/// The equations of motion in print, which are solved in this form, in so many operations.
pub(crate) fn listing(
    model: &mut Model,
    equations: &Equations,
    (declaration, lowered): (&Declaration, &Lowered),
    (solved, operations): (&SolvedForm, usize),
) -> Listing {
    let declared = declared(model, (declaration, lowered), operations);
    Listing::of(model, equations, solved, &declared)
}

/// The names under which the equations of a model are printed.
pub(crate) fn declared(
    model: &Model,
    (declaration, lowered): (&Declaration, &Lowered),
    operations: usize,
) -> Declared {
    let mut definitions = Vec::new();
    let mut seen = BTreeSet::new();
    for definition in &declaration.clauses.definitions {
        let name = unraw(&definition.name);
        if seen.insert(name.clone()) {
            let components = defined(lowered, &definition.name).into_iter();
            definitions.extend(components.map(|(label, x)| (label.to_string(), x)));
        }
    }
    definitions.extend(angular_velocities(&model.graph, lowered));
    let before = lowered.outputs.iter().map(|shape| shape.count()).sum();
    let functions = model.outputs.iter().skip(before).copied();
    Declared {
        names: printed_names(lowered),
        definitions,
        as_declared: as_declared(declaration, lowered),
        operations,
        events: names(declaration, &lowered.events).zip(functions).collect(),
    }
}

/// The components of the angular velocities of bodies, where they are not defined by other names.
fn angular_velocities(graph: &Graph, lowered: &Lowered) -> Vec<(String, Expression)> {
    let names = BodyNames::of(lowered);
    let mut definitions = Vec::new();
    let mut seen = BTreeSet::new();
    for (mass, components) in &lowered.turning {
        let Node::Symbol(Symbol::Parameter(i)) = graph.node(*mass) else {
            continue;
        };
        if let Some(component) = lowered.quantities.parameters.get(*i as usize)
            && seen.insert(*i)
        {
            let names = names.angular_velocity(&component.label);
            definitions.extend(names.into_iter().zip(components.iter().copied()));
        }
    }
    definitions
}
