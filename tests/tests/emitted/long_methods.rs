//! Methods on both sides of the lengths from which on they are divided into pieces and matrices are computed column by column,
//! against the derivatives of the closed form of a chain of pendulums. No lint may flag what is emitted, either.
#![deny(
    warnings,
    clippy::all,
    unused,
    unused_qualifications,
    unused_results,
    trivial_casts
)]

use lagrangian::prelude::*;
use lagrangian_tests::{Figures, Random, relative_error};
use nalgebra::DMatrix;

/// Of the derivatives, relative to their greatest: the mass matrix of 20 links loses some digits.
const TOLERANCE: f64 = 1e-12;
const G: f64 = 9.81;

/// F of Mᵢⱼ = Fᵢⱼ cos(θᵢ − θⱼ), which is the mass that hangs on both links and the lengths of both.
fn inertias(m: &[f64], l: &[f64]) -> DMatrix<f64> {
    DMatrix::from_fn(m.len(), m.len(), |i, j| {
        m[i.max(j)..].iter().sum::<f64>() * l[i] * l[j]
    })
}

/// ∂q̈/∂q and ∂q̈/∂q̇ from rᵢ = Σⱼ Fᵢⱼ (cos(θᵢ − θⱼ) θ̈ⱼ + sin(θᵢ − θⱼ) θ̇ⱼ²) + Fᵢᵢ/lᵢ g sin θᵢ = 0, differentiated by
/// hand: M ∂q̈/∂x = −∂r/∂x.
fn derivatives(m: &[f64], l: &[f64], q: &[f64], v: &[f64]) -> [DMatrix<f64>; 2] {
    let (n, f) = (m.len(), inertias(m, l));
    let angle = |i: usize, j: usize| q[i] - q[j];
    let weight = |i: usize| f[(i, i)] / l[i] * G;
    let mass = DMatrix::from_fn(n, n, |i, j| f[(i, j)] * angle(i, j).cos()).lu();
    let forcing = DMatrix::from_fn(n, 1, |i, _| {
        let centrifugal = (0..n).map(|j| f[(i, j)] * angle(i, j).sin() * v[j].powi(2));
        -centrifugal.sum::<f64>() - weight(i) * q[i].sin()
    });
    let a = mass.solve(&forcing).expect("M is positive definite");
    // ∂r/∂θₖ without the term of θᵢ itself.
    let turned = |i: usize, k: usize| {
        f[(i, k)] * (angle(i, k).sin() * a[k] - angle(i, k).cos() * v[k].powi(2))
    };
    let by_position = DMatrix::from_fn(n, n, |i, k| {
        if i == k {
            let others = (0..n).filter(|j| *j != i).map(|j| turned(i, j));
            weight(i) * q[i].cos() - others.sum::<f64>()
        } else {
            turned(i, k)
        }
    });
    let by_velocity = DMatrix::from_fn(n, n, |i, k| 2.0 * f[(i, k)] * angle(i, k).sin() * v[k]);
    [by_position, by_velocity].map(|columns| {
        let solved = mass.solve(&columns).expect("M is positive definite");
        -solved
    })
}

macro_rules! compare {
    ($n:literal, $figures:ident, $states:expr) => {{
        #[derive(Lagrangian)]
        #[lagrangian(
            coordinates(theta[$n]),
            define(
                p[0] = l[0] * [sin(theta[0]), -cos(theta[0])],
                p[i] = p[i - 1] + l[i] * [sin(theta[i]), -cos(theta[i])] for i in 1..$n,
            ),
            kinetic = (0..$n).map(|i| 0.5 * m[i] * dot(p[i]).norm_squared()).sum(),
            potential = (0..$n).map(|i| m[i] * g * p[i].y).sum(),
        )]
        struct Chain {
            m: [f64; $n],
            l: [f64; $n],
            g: f64,
        }

        let mut random = Random::default();
        for _ in 0..$states {
            let (m, l) = (random.array(0.5, 2.0), random.array(0.5, 2.0));
            let state: State<f64, $n> = random.state();
            let found = Chain { m, l, g: G }.linearize(&state);
            let expected = derivatives(&m, &l, state.q.as_slice(), state.v.as_slice());
            let found = [found.position.as_slice(), found.velocity.as_slice()];
            for ((name, found), expected) in ["∂q", "∂q̇"].into_iter().zip(found).zip(&expected) {
                let error = relative_error(found, expected.as_slice(), 1.0);
                $figures.record(name, &format!("{} links, {state:?}", $n), error, TOLERANCE);
            }
        }
    }};
}

#[test]
#[ignore = "a long sweep; run with `--include-ignored`"]
fn derivatives_are_those_of_the_closed_form() {
    compare_derivatives(20);
}

#[test]
fn derivatives_at_some_states_are_those_of_the_closed_form() {
    compare_derivatives(3);
}

/// Of each chain at so many states.
fn compare_derivatives(states: usize) {
    let mut figures = Figures::new();
    compare!(12, figures, states);
    // The first that is long.
    compare!(20, figures, states);
    // Column by column, from the inverse dynamics on dual numbers.
    compare!(60, figures, states);
    figures.finish();
}
