//! Loops of chains of links in relative angles, whose multipliers are eliminated along the links, beside a dense factorization
//! with complete pivoting.

use lagrangian::prelude::*;
use lagrangian::quantities::{Constraints, Quantities};
use lagrangian_tests::{Random, assert_close};
use nalgebra::{DMatrix, DVector, SMatrix};

use crate::four_bars::{FourChained, chained, expected};

/// Two arms in space that carry a plate between them, on a cart that is pushed: the tip of the second holds the plate of the first
/// by a rod, and rolls along a rail that moves.
#[derive(Clone, Lagrangian)]
#[lagrangian(
    coordinates(s, q[3], u[3]),
    define(
        base = [s, 0.2 * s, 0.0],
        r[0] = rotation_z(q[0]),
        r[1] = r[0] * rotation_y(q[1]),
        r[2] = r[1] * rotation_y(q[2]),
        elbow = base + r[1] * [l, 0.1, 0.0],
        plate = elbow + r[2] * [l, 0.0, -0.2],
        f[0] = rotation_x(0.3) * rotation_z(u[0]),
        f[1] = f[0] * rotation_x(u[1]),
        f[2] = f[1] * rotation_z(u[2]),
        knee = base + [0.0, 1.5, 0.0] + f[1] * [0.2, l, 0.1],
        tip = knee + f[2] * [0.0, l, 0.3],
        w[i] = angular_velocity(r[i]) for i in 0..3,
        o[i] = angular_velocity(f[i]) for i in 0..3,
    ),
    kinetic = 0.5 * cart * dot(base).norm_squared()
        + (0..3).map(|i| 0.5 * w[i].dot(inertia * w[i]) + 0.5 * o[i].dot(inertia * o[i])).sum()
        + 0.5 * m * (dot(elbow).norm_squared() + dot(plate).norm_squared() + dot(knee).norm_squared() + dot(tip).norm_squared()),
    potential = m * g * (elbow.z + plate.z + knee.z + tip.z),
    constraint(
        rod = (plate - tip).norm_squared() - length.powi(2),
        rail = tip.z + 0.1 * t - 0.4,
        coupled = q[0] - 0.5 * u[0],
    ),
    nonholonomic(
        along = cos(q[1]) * dot(plate).x - dot(tip).x + 0.3 * dot(s),
        turning = o[2].z - 0.2 * w[2].x,
    ),
    taylor,
)]
struct Arms {
    cart: f64,
    m: f64,
    g: f64,
    l: f64,
    length: f64,
    inertia: Matrix3<f64>,
}

fn arms() -> Arms {
    Arms {
        cart: 2.0,
        m: 1.5,
        g: 9.81,
        l: 0.8,
        length: 1.1,
        inertia: Matrix3::from_rows(&[
            [0.3, 0.02, 0.01].into(),
            [0.02, 0.4, -0.03].into(),
            [0.01, -0.03, 0.35].into(),
        ]),
    }
}

/// The solution of the saddle point problem of a mass matrix and the gradients of constraints.
fn solved<const N: usize, const C: usize>(
    mass: &SMatrix<f64, N, N>,
    jacobian: &SMatrix<f64, C, N>,
    right: &[f64],
) -> Vec<f64> {
    let matrix = DMatrix::from_fn(N + C, N + C, |i, j| match (i < N, j < N) {
        (true, true) => mass[(i, j)],
        (true, false) => -jacobian[(j - N, i)],
        (false, true) => -jacobian[(i - N, j)],
        (false, false) => 0.0,
    });
    let solution = matrix
        .full_piv_lu()
        .solve(&DVector::from_column_slice(right));
    let solution = solution.expect("a regular matrix");
    solution.iter().copied().collect()
}

/// The accelerations and multipliers of a model at a state, beside those of a dense factorization.
macro_rules! compare {
    ($model:expr, $state:expr) => {{
        let (model, state) = (&$model, &$state);
        let (inputs, prepared) = (Quantities::inputs(model), Quantities::prepare(model));
        let (accelerations, multipliers) =
            Constraints::accelerations_and_multipliers(model, state, &inputs, &prepared);
        let found: Vec<f64> = accelerations.iter().chain(&multipliers).copied().collect();
        let forcing = Quantities::forcing(model, state, &inputs, &prepared);
        let rates = Constraints::constraint_rates(model, state, &prepared);
        let right: Vec<f64> = forcing.iter().chain(&rates).copied().collect();
        let expected = solved(
            &Quantities::mass_matrix(model, state, &prepared),
            &Constraints::constraint_jacobian(model, state, &prepared),
            &right,
        );
        assert_close("q̈ and λ", &found, &expected, 1e-10);
    }};
}

#[test]
fn linkages_in_relative_angles_accelerate_as_a_dense_factorization_says() {
    let mut random = Random::default();
    for _ in 0..200 {
        let mut state = chained::<9>(random.between(-0.5, 0.5), 0.0);
        for q in state.q.iter_mut() {
            *q += random.between(-0.3, 0.3);
        }
        for v in state.v.iter_mut() {
            *v += random.between(-2.0, 2.0);
        }
        compare!(FourChained::NEW, state);
    }
}

#[test]
fn arms_in_space_accelerate_as_a_dense_factorization_says() {
    let mut random = Random::default();
    for _ in 0..200 {
        let q = [(); 7].map(|()| random.between(-1.5, 1.5));
        let v = [(); 7].map(|()| random.between(-2.0, 2.0));
        let state = State::new(random.between(-1.0, 1.0), q, v);
        compare!(arms(), state);
    }
}

/// What carries the load is heavier by twelve orders of magnitude than what transmits it.
#[test]
fn accelerations_of_light_links_meet_the_constraints() {
    let mut random = Random::default();
    let mut heavy = arms();
    heavy.cart = 1e6;
    for _ in 0..50 {
        heavy.m = 1e-6;
        heavy.inertia = arms().inertia * 1e-6;
        let q = [(); 7].map(|()| random.between(-1.5, 1.5));
        let v = [(); 7].map(|()| random.between(-2.0, 2.0));
        let state = State::new(0.0, q, v);
        let prepared = Quantities::prepare(&heavy);
        let jacobian = Constraints::constraint_jacobian(&heavy, &state, &prepared);
        let rates = Constraints::constraint_rates(&heavy, &state, &prepared);
        let accelerations = Lagrangian::accelerations(&heavy, &state);
        let sizes = jacobian.abs() * accelerations.abs();
        let residuals = jacobian * accelerations;
        for i in 0..5 {
            let error = (residuals[i] + rates[i]).abs() / (sizes[i] + rates[i].abs());
            assert!(error < 1e-15, "{i}: {error:e}");
        }
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
