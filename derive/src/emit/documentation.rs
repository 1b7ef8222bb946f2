//! The documentation of the emitted impl: the equations as they were derived, and the operation counts.

use std::collections::BTreeSet;
use std::fmt::Write as _;

use lagrangian_symbolic::{Declared, Equations, Listing, Model, Names, OperationCount};

use super::emitter::Emitter;
use super::events::names;
use crate::lower::Lowered;
use crate::lower::quantities::Component;
use crate::plan::Methods;
use crate::syntax::declaration::Declaration;
use crate::syntax::names::unraw;

/// The documentation of the model's impl: coordinates, energies, mass matrix, equations of motion.
pub(crate) fn of(emitter: &Emitter<'_>, equations: &str) -> String {
    let mut text = String::from(
        "# The equations of motion\n\nd/dt (∂L/∂q̇) − ∂L/∂q = Q (4.6), with\n\n```text\n",
    );
    text.push_str(equations);
    text.push_str("```\n\n# Operations\n\n");
    text.push_str(
        "| method | + − | × | ÷ | √ | sin, cos | others |\n|---|---|---|---|---|---|---|\n",
    );
    for (name, method) in emitter.methods.counted() {
        let OperationCount {
            additions,
            multiplications,
            divisions,
            square_roots,
            sines_and_cosines,
            functions,
        } = method.count;
        // Writing to a `String` does not fail.
        let _ = writeln!(
            text,
            "| `{name}` | {additions} | {multiplications} | {divisions} | {square_roots} | \
             {sines_and_cosines} | {functions} |"
        );
    }
    text
}

/// The equations of motion in print.
pub(crate) fn listing(
    model: &mut Model,
    equations: &Equations,
    declaration: &Declaration,
    lowered: &Lowered,
    methods: &Methods,
) -> Listing {
    let scope = &lowered.scope;
    let mut definitions = Vec::new();
    let mut seen = BTreeSet::new();
    for definition in &declaration.clauses.definitions {
        let name = unraw(&definition.name);
        if seen.insert(name.clone()) {
            let components = scope.defined(&name).into_iter();
            definitions.extend(components.map(|(label, x)| (label.to_string(), x)));
        }
    }
    let before = lowered.outputs.iter().map(|shape| shape.count()).sum();
    let functions = model.outputs.iter().skip(before).copied();
    let declared = Declared {
        names: printed_names(lowered),
        definitions,
        operations: methods.accelerations.count.total(),
        events: names(declaration, &lowered.events).zip(functions).collect(),
    };
    let solved = methods.solved_form(model, equations);
    Listing::of(model, equations, &solved, &declared)
}

/// The names of coordinates, parameters and inputs.
pub(super) fn printed_names(lowered: &Lowered) -> Names {
    let quantities = &lowered.quantities;
    let all = |components: &[Component]| -> Vec<String> {
        let labels = components.iter().map(|component| &component.label);
        labels.map(ToString::to_string).collect()
    };
    let coordinates = quantities.coordinates.iter();
    Names {
        coordinates: coordinates.map(ToString::to_string).collect(),
        parameters: all(&quantities.parameters),
        inputs: all(&quantities.inputs),
        ..Names::default()
    }
}
