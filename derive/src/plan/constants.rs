//! The constants that a model has besides the indices of its coordinates and inputs.

use crate::syntax::declaration::Declaration;
use crate::syntax::field::Role;

/// The constants of a declared model, each with the kind of models that have it.
pub(crate) fn constants(
    declaration: &Declaration,
) -> impl Iterator<Item = (&'static str, &'static str)> {
    let clauses = &declaration.clauses;
    let has_inputs = declaration.fields_with(Role::Input).next().is_some();
    let has_constraints = !clauses.constraints.is_empty() || !clauses.nonholonomic.is_empty();
    let has_sensitivities = clauses.sensitivities.is_some();
    let rows: [(bool, &'static str, &'static [&'static str]); 11] = [
        (
            true,
            "model",
            &["COORDINATES", "OPERATIONS", "EQUATIONS", "LATEX"],
        ),
        (true, "model", &CONSTANTS_OF_TRAITS),
        (
            true,
            "model with constants of motion",
            &CONSTANTS_OF_CONSERVATION,
        ),
        (clauses.routhian.is_some(), "reduced model", &["ELIMINATED"]),
        (has_inputs, "model with inputs", &["INPUTS"]),
        (
            !clauses.functions.is_empty(),
            "model with external functions",
            &["FUNCTIONS"],
        ),
        (!clauses.events.is_empty(), "model with events", &["EVENTS"]),
        (has_constraints, "model with constraints", &["CONSTRAINTS"]),
        (
            has_sensitivities,
            "model with `sensitivities`",
            &["PARAMETERS"],
        ),
        (
            clauses.regressor.is_some(),
            "model with a `regressor`",
            &["BASE_PARAMETERS", "WITHOUT_EFFECT"],
        ),
        (
            clauses.c.is_some(),
            "model with `c`",
            &["C_SOURCE", "C_HEADER", "C_CASADI"],
        ),
    ];
    let rows = rows.into_iter().filter(|(there, ..)| *there);
    rows.flat_map(|(_, kind, names)| names.iter().map(move |name| (*name, kind)))
}

/// The constants of traits that a model has; a constant of the type would hide them.
const CONSTANTS_OF_TRAITS: [&str; 6] = [
    "ANGLES",
    "PERIODS",
    "IGNORABLE",
    "SINGULARITIES",
    "STAYS_REGULAR",
    "POLES",
];

/// The constants of a model with constants of motion. Whether it has any is known after its equations: no model has
/// others of these names.
const CONSTANTS_OF_CONSERVATION: [&str; 3] = [
    "CONSTANTS_OF_MOTION",
    "IGNORABLE_COORDINATES",
    "CONSERVES_ENERGY",
];
