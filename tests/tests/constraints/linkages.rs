//! Loops in a row, whose accelerations and multipliers are found by elimination in an order of least fill: beside a dense
//! factorization with complete pivoting, also where a pivot is so small that the model pivots itself.

use lagrangian::prelude::*;
use lagrangian_tests::{Random, assert_close};

use crate::dense::solutions;
use crate::four_bars::{SixFourBars, upright};

const CRANKS: usize = 7;
const COORDINATES: usize = 2 * CRANKS;

type Row = State<f64, COORDINATES>;

/// The state with all cranks at this angle to the upright, which turn at this rate.
fn parallel(angle: f64, rate: f64) -> Row {
    let mut state = upright::<CRANKS, COORDINATES>(rate);
    let (sine, cosine) = angle.sin_cos();
    for i in 0..CRANKS {
        state.q[i] += sine;
        state.q[CRANKS + i] = cosine;
        state.v[i] = rate * cosine;
        state.v[CRANKS + i] = -rate * sine;
    }
    state
}

#[test]
fn accelerations_and_multipliers_are_those_of_a_dense_factorization() {
    let mut random = Random::default();
    for _ in 0..100 {
        let mut state = parallel(random.between(-0.7, 0.7), random.between(-2.0, 2.0));
        for q in state.q.iter_mut() {
            *q += random.between(-0.2, 0.2);
        }
        for v in state.v.iter_mut() {
            *v += random.between(-0.5, 0.5);
        }
        let [found, expected] = solutions(&SixFourBars::NEW, &state);
        assert_close("q̈ and λ", &found, &expected, 1e-10);
    }
}

/// Near the flat configuration each loop loses the square of the distance.
#[test]
fn near_singular_configurations_no_more_digits_are_lost_than_by_a_dense_factorization() {
    for distance in [0.05, 0.02, 0.01] {
        let state = parallel(core::f64::consts::FRAC_PI_2 - distance, 1.0);
        let [found, expected] = solutions(&SixFourBars::NEW, &state);
        assert_close("q̈ and λ", &found, &expected, 1e-8);
    }
}

#[test]
fn steps_that_end_where_the_model_pivots_are_counted() {
    let pivoted = |angle: f64| {
        let problem = Problem::new(&SixFourBars::NEW, parallel(angle, 1.0));
        let end = problem.solve(0.01, RungeKutta::classical(1e-3)).unwrap();
        assert_eq!(end.statistics.steps, 10);
        end.statistics.pivoted
    };
    assert_eq!(pivoted(0.0), 0);
    assert_eq!(pivoted(core::f64::consts::FRAC_PI_2 - 0.04), 10);
}
