//! The 200 random Lagrangians in motion: the state a quarter of a second after the first one.

use lagrangian::prelude::*;
use lagrangian::quantities::Inputs;
use lagrangian_tests::{
    Figures, Parametrized, array, number, numbers, public_cases, relative_error, rows,
};
use nalgebra::SVector;
use serde_json::Value;

/// Relative to the greatest coordinate or velocity, or to 1 if that is greater.
const TOLERANCE: f64 = 1e-9;

/// The references have no end of these motions.
const WITHOUT_END: [&str; 2] = ["public-A-054", "public-A-067"];

/// A case: its identifier, and its coordinates and velocities at the end.
type Row = (&'static str, fn(&Value) -> [Vec<f64>; 2]);

const CASES: &[Row] = &lagrangian_tests::public_cases!(free, driven);

#[test]
fn motions_arrive_at_the_references() {
    let mut figures = Figures::new();
    for (case, &(id, end)) in public_cases().iter().zip(CASES) {
        assert_eq!(case["id"], id);
        if WITHOUT_END.contains(&id) {
            assert!(case["flow"].is_null(), "{id} has an end by now");
            continue;
        }
        let [q, v] = end(case);
        figures.record(
            "q",
            id,
            relative_error(&q, &numbers(&case["flow"]["q"]), 1.0),
            TOLERANCE,
        );
        figures.record(
            "qd",
            id,
            relative_error(&v, &numbers(&case["flow"]["qd"]), 1.0),
            TOLERANCE,
        );
    }
    figures.finish();
}

fn free<M, const N: usize>(case: &Value) -> [Vec<f64>; 2]
where
    M: Parametrized + Lagrangian<N>,
{
    let model = M::with(&|name| number(&case["params"][name]));
    integrate(&model.dynamics(), case)
}

fn driven<M, const N: usize, const U: usize>(case: &Value) -> [Vec<f64>; 2]
where
    M: Parametrized + Lagrangian<N, Model: Inputs<N, U>>,
{
    let first = &case["states"][0]["u"];
    let model = M::with(&|name| number(first.get(name).unwrap_or_else(|| &case["params"][name])));
    let held: SVector<f64, U> = model.inputs();
    integrate(&model.with_inputs(held).dynamics(), case)
}

/// The integrator is compiled for each number of coordinates, not for each model.
fn integrate<const N: usize>(
    dynamics: &dyn Dynamics<State = Phase<f64, N>>,
    case: &Value,
) -> [Vec<f64>; 2] {
    assert_eq!(case["flow"]["from_state"], 0);
    let first = &case["states"][0];
    let initial: State<f64, N> =
        State::new(number(&first["t"]), array(&first["q"]), array(&first["qd"]));
    let end = initial.t + number(&case["flow"]["dt"]);
    let method = Dop853::new()
        .relative_tolerance(1e-13)
        .absolute_tolerance(1e-13);
    match Problem::new(dynamics, initial).solve(end, method) {
        Ok(state) => [rows(&state.q), rows(&state.v)],
        Err(error) => panic!("{}: {error}", case["id"]),
    }
}
