//! Linear-quadratic regulators beside those of `SciPy`.

use std::{fs, path::Path};

use lagrangian::analysis::{DiscreteStateSpace, Regulator, RegulatorError, StateSpace};
use nalgebra::SMatrix;
use serde_json::Value;

use crate::at::numbers;
use crate::{Comparison, Entries, rows};

/// Solves every problem of a file, and compares the gain K and the cost P.
///
/// # Panics
///
/// If the data cannot be read.
#[must_use]
pub fn compare_regulators(file: &Path) -> Vec<Comparison> {
    let text = fs::read_to_string(file).expect("the file of regulators can be read");
    let document: Value = serde_json::from_str(&text).expect("the file of regulators is JSON");
    let problems = document["regulators"]
        .as_array()
        .expect("a list of problems");
    problems.iter().flat_map(compared).collect()
}

fn compared(problem: &Value) -> Vec<Comparison> {
    let size = |name: &str| {
        problem[name]
            .as_u64()
            .expect("a number of states or inputs")
    };
    let found = match (size("states"), size("inputs")) {
        (2, 1) => solved::<2, 1>(problem),
        (2, 2) => solved::<2, 2>(problem),
        (4, 1) => solved::<4, 1>(problem),
        (4, 2) => solved::<4, 2>(problem),
        (6, 2) => solved::<6, 2>(problem),
        other => panic!("no regulators of {other:?} states and inputs"),
    };
    let found = match found {
        Ok([cost, gain]) => [("cost", Ok(cost)), ("gain", Ok(gain))],
        Err(error) => ["cost", "gain"].map(|quantity| (quantity, Err(error.to_string()))),
    };
    let of = |name: &str| problem[name].as_str().expect("a name");
    let comparison = |(quantity, found): (&str, Entries)| Comparison {
        model: format!("{}: {}", of("id"), of("kind")),
        state: 0,
        quantity: quantity.to_owned(),
        found,
        expected: numbers(&problem[quantity]),
        tolerance: numbers(&problem["tolerances"][quantity])[0],
        conditioning: None,
    };
    found.map(comparison).into()
}

/// The cost and the gain, row by row.
fn solved<const D: usize, const U: usize>(
    problem: &Value,
) -> Result<[Vec<f64>; 2], RegulatorError> {
    let (a, b) = (matrix::<D, D>(&problem["a"]), matrix::<D, U>(&problem["b"]));
    let (q, r) = (matrix::<D, D>(&problem["q"]), matrix::<U, U>(&problem["r"]));
    let Regulator { gain, cost, .. } = if problem["discrete"] == true {
        DiscreteStateSpace::new(a, b, 1.0).regulator(&q, &r)?
    } else {
        StateSpace::new(a, b).regulator(&q, &r)?
    };
    Ok([rows(&cost), rows(&gain)])
}

fn matrix<const R: usize, const C: usize>(value: &Value) -> SMatrix<f64, R, C> {
    SMatrix::from_row_slice(&numbers(value))
}
