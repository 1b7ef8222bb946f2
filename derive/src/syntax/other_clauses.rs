//! What other programs call the clauses, and what no clause says because it is said elsewhere.

use syn::Token;
use syn::parse::ParseStream;

/// The clause that has another name elsewhere.
pub(super) fn called_otherwise(written: &str) -> Option<&'static str> {
    let clause = match written {
        "T" | "KE" => "kinetic",
        "V" | "U" | "PE" => "potential",
        "L" => "lagrangian",
        "q" | "state" | "states" | "dofs" | "coords" | "variables" | "generalized_coordinates" => {
            "coordinates"
        }
        "damping" | "damper" | "rayleigh" => "dissipation",
        "torque" | "torques" | "moment" | "generalized_force" | "generalized_forces"
        | "external_force" | "external_forces" | "drag" => "force",
        "constraints" | "holonomic" | "loop" | "closure" | "loops" => "constraint",
        "rolling" | "no_slip" | "nonholonomic_constraint" => "nonholonomic",
        "compliances" | "stiffness" | "stiffnesses" => "compliance",
        "observables" | "measurements" => "output",
        "definitions" | "with" => "define",
        "bodies" | "links" => "body",
        "C" | "c99" | "source" => "c",
        "python" | "reflection" | "names" => "reflect",
        "reduce" | "reduced" | "ignorable" | "cyclic" => "routhian",
        _ => return None,
    };
    Some(clause)
}

/// Where that is said for which there is no clause.
pub(super) fn said_elsewhere(written: &str) -> Option<&'static str> {
    let place = match written {
        "input" | "inputs" | "control" | "controls" => {
            "an input is a field of the struct, marked `#[lagrangian(input)]`"
        }
        "param" | "params" | "parameter" | "parameters" | "constant" | "constants" | "mass" => {
            "parameters are the fields of the struct"
        }
        "skip" => "a field that is no parameter is marked `#[lagrangian(skip)]`",
        "initial" | "initial_conditions" | "initial_state" | "start" => {
            "initial values are given where the motion is integrated, `State::new(t, q, v)`"
        }
        "integrator" | "method" | "order" | "tolerance" | "dop853" => {
            "integrators and their settings are chosen where the motion is integrated, as in `Dop853::new()`"
        }
        "linearize" | "linearization" => "every model has it, `model.linearize(&state)`",
        "lambda" | "multiplier" | "multipliers" | "reaction" | "reactions" => {
            "the multipliers of `constraint(name = …)` are computed: `model.multipliers(&state)` has them, and an output or an \
             event reads them as `reaction(name)`"
        }
        "friction" => {
            "write `dissipation = 0.5 * b * dot(x).powi(2)` for friction that is linear in the velocity, and \
             `force(x = …)` for any other"
        }
        _ => return None,
    };
    Some(place)
}

/// For a keyword of Rust with which no clause begins.
pub(super) fn keyword(input: ParseStream<'_>) -> Option<syn::Error> {
    let message = if input.peek(Token![let]) || input.peek(Token![where]) {
        "quantities are named by `define(name = expression, …)`"
    } else if input.peek(Token![fn]) {
        "a function is declared by `function(f(x) = value, derivative(x) = …)`"
    } else {
        return None;
    };
    Some(input.error(message))
}
