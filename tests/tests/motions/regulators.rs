//! Regulators of badly scaled problems, against reference values (`data/regulators.json`).

use lagrangian::analysis::{DiscreteStateSpace, Regulator, RegulatorError, StateSpace};
use lagrangian::prelude::*;
use lagrangian_tests::{Figures, list, regulators, relative_error};
use serde_json::Value;

fn matrix<const R: usize, const C: usize>(value: &Value) -> SMatrix<f64, R, C> {
    SMatrix::from_fn(|i, j| value[i][j].as_f64().unwrap())
}

fn regulator<const D: usize, const U: usize>(
    is_discrete: bool,
    [a, q]: [SMatrix<f64, D, D>; 2],
    b: SMatrix<f64, D, U>,
    r: SMatrix<f64, U, U>,
) -> Result<Regulator<D, U>, RegulatorError> {
    if is_discrete {
        DiscreteStateSpace::new(a, b, 1.0).regulator(&q, &r)
    } else {
        StateSpace::new(a, b).regulator(&q, &r)
    }
}

#[test]
fn badly_scaled_problems_are_solved() {
    let mut figures = Figures::new();
    for (index, case) in list(&regulators()).iter().enumerate() {
        let is_discrete = case["discrete"].as_bool().unwrap();
        let at = format!("case {index}, {}", case["kind"]);
        let (a, q) = (matrix::<4, 4>(&case["a"]), matrix(&case["q"]));
        let (b, r) = (matrix::<4, 2>(&case["b"]), matrix(&case["r"]));
        let found = regulator(is_discrete, [a, q], b, r);
        let found = found.unwrap_or_else(|error| panic!("{at}: {error}"));
        let expected = matrix::<2, 4>(&case["gain"]);
        let error = relative_error(found.gain.as_slice(), expected.as_slice(), 1e-30);
        figures.record("gain", &at, error, 1e-9);
        let scaled = regulator(is_discrete, [a, q * 1e6], b, r * 1e6).unwrap();
        let error = relative_error(scaled.gain.as_slice(), expected.as_slice(), 1e-30);
        figures.record("gain of other units of cost", &at, error, 1e-9);
    }
    figures.finish();
}
