//! 200 random Lagrangians: what the derived code evaluates at four states of each, against
//! references of 30 digits.

use lagrangian::quantities::{Energies, Inputs, StateJacobian};
use lagrangian::{Lagrangian, State};
use lagrangian_tests::{
    Figures, Parametrized, array, list, number, numbers, public_cases, relative_error, rows,
};
use serde_json::Value;

/// Relative to the greatest entry of a vector or matrix, or to `FLOOR` if that is greater.
const TOLERANCE: f64 = 1e-11;
const FLOOR: f64 = 1e-3;

/// What is evaluated: the quantity, what was found and what was expected.
type Comparison = (&'static str, Vec<f64>, Vec<f64>);

/// A case: its identifier, and the comparisons at one of its states.
type Row = (&'static str, fn(&Value, &Value) -> Vec<Comparison>);

const CASES: &[Row] = &lagrangian_tests::public_cases!(free, driven);

#[test]
fn derived_code_agrees_with_the_references() {
    let mut figures = Figures::new();
    for (case, &(id, compare)) in public_cases().iter().zip(CASES) {
        assert_eq!(case["id"], id);
        for (index, state) in list(&case["states"]).iter().enumerate() {
            for (quantity, found, expected) in compare(case, state) {
                let error = relative_error(&found, &expected, FLOOR);
                figures.record(quantity, &format!("{id}, state {index}"), error, TOLERANCE);
            }
        }
    }
    figures.finish();
}

/// Compares what a model without inputs evaluates.
fn free<M, const N: usize>(case: &Value, state: &Value) -> Vec<Comparison>
where
    M: Parametrized + Lagrangian<N, Model: Energies<N> + StateJacobian<N>>,
{
    let model = M::with(&|name| number(&case["params"][name]));
    compare(&model, state)
}

/// Compares what a model with inputs evaluates: with their values in its fields, and set from
/// outside.
fn driven<M, const N: usize, const U: usize>(case: &Value, state: &Value) -> Vec<Comparison>
where
    M: Parametrized + Lagrangian<N, Model: Energies<N> + Inputs<N, U> + StateJacobian<N>>,
{
    let valued = |name: &str| {
        state["u"]
            .get(name)
            .unwrap_or_else(|| &case["params"][name])
    };
    let model = M::with(&|name| number(valued(name)));
    let mut comparisons = compare(&model, state);
    let at = point(state);
    comparisons.push((
        "dqdd_du",
        rows(&model.input_jacobian(&at)),
        numbers(&state["dqdd_du"]),
    ));

    // Fields that hold no number would show in every result that uses them.
    let unset = M::with(&|name| case["params"].get(name).map_or(f64::NAN, number));
    comparisons.extend(compare_motion(&unset.with_inputs(model.inputs()), state));
    comparisons
}

fn point<const N: usize>(state: &Value) -> State<f64, N> {
    State::new(number(&state["t"]), array(&state["q"]), array(&state["qd"]))
}

fn compare<M: Lagrangian<N, Model: Energies<N> + StateJacobian<N>>, const N: usize>(
    model: &M,
    state: &Value,
) -> Vec<Comparison> {
    let at = point(state);
    let mut comparisons = compare_motion(model, state);
    comparisons.extend([
        ("T", vec![model.kinetic_energy(&at)], numbers(&state["T"])),
        ("V", vec![model.potential_energy(&at)], numbers(&state["V"])),
    ]);
    comparisons
}

fn compare_motion<M: Lagrangian<N, Model: StateJacobian<N>>, const N: usize>(
    model: &M,
    state: &Value,
) -> Vec<Comparison> {
    let at = point(state);
    let expected = |quantity: &str| numbers(&state[quantity]);
    let linearization = model.linearize(&at);
    let mut comparisons = vec![
        ("M", rows(&model.mass_matrix(&at)), expected("M")),
        ("f", rows(&model.forcing(&at)), expected("rhs")),
        ("qdd", rows(&model.accelerations(&at)), expected("qdd")),
        ("h", vec![model.energy(&at)], expected("jacobi")),
        (
            "L",
            vec![model.lagrangian(&at)],
            vec![number(&state["T"]) - number(&state["V"])],
        ),
        ("p", rows(&model.momenta(&at)), expected("p")),
        ("Q", rows(&model.generalized_forces(&at)), expected("Q")),
        (
            "dqdd_dq",
            rows(&linearization.position),
            expected("dqdd_dq"),
        ),
        (
            "dqdd_dqd",
            rows(&linearization.velocity),
            expected("dqdd_dqd"),
        ),
        ("dqdd_dt", rows(&linearization.time), expected("dqdd_dt")),
    ];
    comparisons.extend(compare_inverse_dynamics(model, &at, state));
    comparisons
}

/// M q̈ − f with f added to it again is M q̈, which is f for the accelerations of the motion;
/// without accelerations it is −f.
fn compare_inverse_dynamics<M: Lagrangian<N>, const N: usize>(
    model: &M,
    at: &State<f64, N>,
    state: &Value,
) -> [Comparison; 2] {
    let forcing = nalgebra::SVector::<f64, N>::from(array(&state["rhs"]));
    let of_motion = model.inverse_dynamics(at, &array(&state["qdd"]).into());
    let of_rest = model.inverse_dynamics(at, &nalgebra::SVector::zeros());
    [
        (
            "M qdd, inverse dynamics",
            rows(&(of_motion + forcing)),
            rows(&forcing),
        ),
        ("-f, inverse dynamics", rows(&of_rest), rows(&-forcing)),
    ]
}
