//! The Lagrange points of the restricted problem of three bodies, and their stability.

use crate::common::assert_close;
use lagrangian::analysis::{
    EquilibriumSearch, LinearStability, SecondVariation, SmallOscillations, Verdict,
};
use lagrangian::prelude::*;
use lagrangian::{DoubleDouble, Scalar};

/// The restricted problem of three bodies in the rotating frame, in units of the distance and the angular velocity of the primaries.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(x, y),
    define(
        r1 = ((x + mu).powi(2) + y.powi(2)).sqrt(),
        r2 = ((x - 1 + mu).powi(2) + y.powi(2)).sqrt(),
    ),
    kinetic = 0.5 * ((dot(x) - y).powi(2) + (dot(y) + x).powi(2)),
    potential = -(1 - mu) / r1 - mu / r2,
)]
struct ThreeBodies<T: Scalar = f64> {
    mu: T,
}

fn rest<const N: usize>(q: [f64; N]) -> State<f64, N> {
    State::new(0.0, q, [0.0; N])
}

/// Along the ring of the orbit the potential is nearly constant, and where Newton's paths from these guesses lead, the Jacobian is
/// singular.
#[test]
fn from_beyond_a_singular_jacobian() {
    let mut descents = 0;
    for mu in [0.3, 0.05, 0.012, 0.001] {
        for [x, y] in [
            [0.4, 0.8],
            [0.45, 0.85],
            [0.3, 0.9],
            [0.6, 0.6],
            [0.45, -0.7_f64],
        ] {
            let found = EquilibriumSearch::of(&ThreeBodies { mu })
                .near(&rest([x, y]))
                .unwrap();
            assert_close(found.state.q[0], 0.5 - mu, 1e-12);
            assert_close(found.state.q[1], y.signum() * 0.75_f64.sqrt(), 1e-12);
            descents += usize::from(found.report.descent_steps > 0);
        }
    }
    assert!(descents > 0);
}

/// Lagrange's points: the triangular ones exactly, the collinear ones of the Earth and the Moon as published
/// (V. Szebehely, *Theory of Orbits*, 1967, for μ = 0.012150 and thereabouts) by the quintic equations of Euler.
#[test]
fn lagrange_points() {
    let model = ThreeBodies { mu: 0.012_15 };
    let find = |x, y| {
        EquilibriumSearch::of(&model)
            .near(&rest([x, y]))
            .unwrap()
            .state
            .q
    };
    for sign in [1.0, -1.0] {
        let found = find(0.45, sign * 0.8);
        assert_close(found[0], 0.5 - model.mu, 1e-15);
        assert_close(found[1], sign * 0.75_f64.sqrt(), 1e-15);
    }
    let mu = model.mu;
    let slope = |x: f64| {
        let [first, second] = [x + mu, x - 1.0 + mu];
        x - (1.0 - mu) * first / first.abs().powi(3) - mu * second / second.abs().powi(3)
    };
    for [mut low, mut high, guess] in [[0.5, 0.98, 0.8], [0.995, 1.5, 1.2], [-1.5, -0.5, -0.9]] {
        while high - low > 1e-15 {
            let middle = 0.5 * (low + high);
            if middle <= low || middle >= high {
                break;
            }
            if slope(middle) < 0.0 {
                low = middle;
            } else {
                high = middle;
            }
        }
        let found = find(guess, 0.0);
        assert_close(found[0], low, 1e-13);
        assert_close(found[1], 0.0, 0.0);
    }
}

/// With 30 digits, and with derivatives by parameters.
#[test]
fn other_scalars() {
    let mu = DoubleDouble::from_f64(0.3);
    let zero = DoubleDouble::from_f64(0.0);
    let guess = State::new(zero, [0.2, 0.8].map(DoubleDouble::from_f64), [zero; 2]);
    let found = EquilibriumSearch::of(&ThreeBodies { mu })
        .near(&guess)
        .unwrap();
    let height = DoubleDouble::from_f64(0.75).sqrt();
    assert_close((found.state.q[1] - height).to_f64(), 0.0, 1e-30);
}

/// λ⁴ + λ² + (27/4) μ (1 − μ) = 0 about the triangular points: stable up to Routh's ratio 0.0385208965…, though the effective
/// potential has a maximum there.
#[test]
fn triangular_points() {
    let ratio = 0.5 * (1.0 - (23.0_f64 / 27.0).sqrt());
    assert_close(ratio, 0.038_520_896_5, 1e-10);
    for mu in [0.001, 0.012_15, ratio - 1e-6, ratio + 1e-6, 0.1, 0.5] {
        let model = ThreeBodies { mu };
        let state = EquilibriumSearch::of(&model)
            .near(&rest([0.4, 0.8]))
            .unwrap()
            .state;
        let oscillations = SmallOscillations::about(&model, &state).unwrap();
        let stability = oscillations.stability().unwrap();
        assert_eq!(
            stability.second_variation,
            SecondVariation::NotPositive { negative: 2 }
        );
        let is_below = mu < ratio;
        let verdict = if is_below {
            Verdict::LinearlyStable
        } else {
            Verdict::Unstable
        };
        assert_eq!(stability.verdict(), verdict, "μ = {mu}: {stability:?}");
        let product = 6.75 * mu * (1.0 - mu);
        for value in oscillations.spectrum().unwrap().iter() {
            let square = value * value;
            let left = square * square + square + product;
            assert!(left.norm_sqr().sqrt() < 1e-13, "{left}");
        }
        if !is_below {
            let LinearStability::Growing { rate } = stability.linear else {
                panic!("{stability:?}");
            };
            // Re √((−1 + i √(27 μ (1 − μ) − 1))/2).
            assert_close(rate, (0.5 * (product.sqrt() - 0.5)).sqrt(), 1e-9);
        }
        let error = oscillations.normal_modes().unwrap_err();
        assert!(
            error.to_string().contains("`damped_modes` has the modes"),
            "{error}"
        );
    }
    // The collinear ones are saddles.
    let model = ThreeBodies { mu: 0.012_15 };
    let state = EquilibriumSearch::of(&model)
        .near(&rest([0.8, 0.0]))
        .unwrap()
        .state;
    let stability = SmallOscillations::about(&model, &state)
        .unwrap()
        .stability()
        .unwrap();
    assert_eq!(
        stability.second_variation,
        SecondVariation::NotPositive { negative: 1 }
    );
    assert_eq!(stability.verdict(), Verdict::Unstable);
}
