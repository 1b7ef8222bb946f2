//! A slider under friction, a curve that is computed on every scalar.

use lagrangian::prelude::*;
use lagrangian_tests::{Dual, assert_close};

use super::{STATES, TOLERANCE, computed};

/// A friction curve on every scalar: tanh(v) (0.4 + 0.2 exp(−v²)), which falls from rest to sliding.
mod friction {
    use lagrangian::Scalar;

    pub(super) fn stribeck<S: Scalar>(v: S) -> S {
        v.tanh() * (S::from_f64(0.4) + falling(v))
    }

    pub(super) fn slope<S: Scalar>(v: S) -> S {
        let steep = S::one() - v.tanh() * v.tanh();
        steep * (S::from_f64(0.4) + falling(v)) - v.tanh() * v * (falling(v) + falling(v))
    }

    fn falling<S: Scalar>(v: S) -> S {
        S::from_f64(0.2) * (-v * v).exp()
    }
}

/// A slider on a spring, under friction that is an external function.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(x),
    function(stribeck(v) = friction::stribeck(v), derivative(v) = slope(v)),
    function(slope(v) = friction::slope(v)),
    function(half() = Scalar::from_f64(0.5)),
    kinetic = half() * m * dot(x).powi(2),
    potential = half() * k * x.powi(2),
    force(x = -load * stribeck(dot(x))),
    output(friction = load * stribeck(dot(x)), rate = dot(stribeck(dot(x)))),
)]
struct Slider {
    m: f64,
    k: f64,
    load: f64,
}

/// The same in elementary functions.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(x),
    define(stribeck = tanh(dot(x)) * (0.4 + 0.2 * exp(-dot(x).powi(2)))),
    kinetic = 0.5 * m * dot(x).powi(2),
    potential = 0.5 * k * x.powi(2),
    force(x = -load * stribeck),
    output(friction = load * stribeck, rate = dot(stribeck)),
)]
struct ElementarySlider {
    m: f64,
    k: f64,
    load: f64,
}

#[test]
fn a_friction_curve_is_a_force() {
    let (m, k, load) = (2.0, 3.0, 9.81);
    let slider = Slider { m, k, load };
    let elementary = ElementarySlider { m, k, load };
    for [t, x, v] in STATES {
        let state = State::new(t, [x], [v]);
        let accelerations = SVector::from([0.3]);
        assert_close(
            "slider",
            &computed(&slider, &state, &accelerations),
            &computed(&elementary, &state, &accelerations),
            TOLERANCE,
        );
        let (found, expected) = (slider.outputs(&state), elementary.outputs(&state));
        assert_close(
            "outputs",
            &[found.friction, found.rate],
            &[expected.friction, expected.rate],
            TOLERANCE,
        );
    }
}

#[test]
fn functions_of_every_scalar_are_evaluated_on_every_scalar() {
    let slider = Slider {
        m: 2.0,
        k: 3.0,
        load: 9.81,
    };
    let derivative = slider.linearize(&State::new(0.0, [0.3], [0.7])).velocity[0];
    let [t, x] = [0.0, 0.3].map(Dual::constant);
    let state = State::new(t, [x], [Dual::new(0.7, 1.0)]);
    let found = slider.accelerations(&state)[0].derivative();
    assert_close("dual", &[found], &[derivative], TOLERANCE);
    let single: State<f32, 1> = State::new(0.0, [0.3], [0.7]);
    let single = f64::from(slider.accelerations(&single)[0]);
    let double = slider.accelerations(&State::new(0.0, [0.3], [0.7]))[0];
    assert!(
        (single - double).abs() < 1e-5 * double.abs(),
        "{single} for {double}"
    );
}
