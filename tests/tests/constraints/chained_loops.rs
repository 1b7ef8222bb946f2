//! Loops of chains of links in relative angles, whose multipliers are eliminated along the links, beside a dense factorization
//! with complete pivoting.

use lagrangian::prelude::*;
use lagrangian::quantities::{Constraints, Quantities};
use lagrangian_tests::{Random, assert_close};
use nalgebra::{DMatrix, DVector};

use crate::four_bars::{FourChained, chained, expected};

const COORDINATES: usize = 9;
const CONSTRAINTS: usize = 8;

/// The accelerations and multipliers by a dense factorization of the saddle point problem.
fn expected_accelerations(state: &State<f64, COORDINATES>) -> Vec<f64> {
    let model = &FourChained::NEW;
    let (inputs, prepared) = (Quantities::inputs(model), Quantities::prepare(model));
    let mass = Quantities::mass_matrix(model, state, &prepared);
    let jacobian = Constraints::constraint_jacobian(model, state, &prepared);
    let forcing = Quantities::forcing(model, state, &inputs, &prepared);
    let rates = Constraints::constraint_rates(model, state, &prepared);
    let size = COORDINATES + CONSTRAINTS;
    let matrix = DMatrix::from_fn(size, size, |i, j| {
        match (i < COORDINATES, j < COORDINATES) {
            (true, true) => mass[(i, j)],
            (true, false) => -jacobian[(j - COORDINATES, i)],
            (false, true) => -jacobian[(i - COORDINATES, j)],
            (false, false) => 0.0,
        }
    });
    let right = forcing.iter().chain(&rates).copied();
    let right = DVector::from_iterator(size, right);
    let solution = matrix.full_piv_lu().solve(&right);
    let solution = solution.expect("a regular matrix");
    solution.iter().copied().collect()
}

#[test]
fn linkages_in_relative_angles_accelerate_as_a_dense_factorization_says() {
    let mut random = Random::default();
    for _ in 0..200 {
        let mut state = chained::<COORDINATES>(random.between(-0.5, 0.5), 0.0);
        for q in state.q.iter_mut() {
            *q += random.between(-0.3, 0.3);
        }
        for v in state.v.iter_mut() {
            *v += random.between(-2.0, 2.0);
        }
        let model = &FourChained::NEW;
        let (accelerations, multipliers) = Constraints::accelerations_and_multipliers(
            model,
            &state,
            &Quantities::inputs(model),
            &Quantities::prepare(model),
        );
        let found: Vec<f64> = accelerations.iter().chain(&multipliers).copied().collect();
        let expected = expected_accelerations(&state);
        assert_close("q̈ and λ", &found, &expected, 1e-10);
    }
}

/// As long as all cranks are parallel, the linkages move as one pendulum.
#[test]
fn linkages_in_relative_angles_move_as_a_pendulum() {
    let end = Problem::new(&FourChained::NEW, chained(0.0, 1.0))
        .solve(0.5, Taylor::new())
        .unwrap();
    let difference = end.q[0].cos() - expected(4.0, 1.0, 0.5);
    assert!(difference.abs() < 1e-12, "{difference:e}");
}
