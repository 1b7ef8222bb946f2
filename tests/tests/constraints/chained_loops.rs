//! Loops of chains of links in relative angles, whose multipliers are eliminated along the links, beside a dense factorization
//! with complete pivoting.

use lagrangian::prelude::*;
use lagrangian_tests::{Random, assert_close};

use crate::dense::solutions;
use crate::four_bars::{FourChained, chained, expected};

const COORDINATES: usize = 9;

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
        let [found, expected] = solutions(&FourChained::NEW, &state);
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

/// In the flat configuration, the angles of a loop no longer determine its multipliers.
#[test]
fn near_flat_configurations_linkages_in_relative_angles_are_pivoted() {
    for distance in [0.05, 0.02, 0.01] {
        let state = chained::<COORDINATES>(core::f64::consts::FRAC_PI_2 - distance, 1.0);
        let [found, expected] = solutions(&FourChained::NEW, &state);
        assert_close("q̈ and λ", &found, &expected, 1e-8);
    }
    let pivoted = |angle: f64| {
        let problem = Problem::new(&FourChained::NEW, chained(angle, 1.0));
        let end = problem.solve(0.005, RungeKutta::classical(1e-3)).unwrap();
        end.statistics.pivoted
    };
    assert_eq!(pivoted(0.3), 0);
    assert_eq!(pivoted(core::f64::consts::FRAC_PI_2 - 0.03), 5);
}
