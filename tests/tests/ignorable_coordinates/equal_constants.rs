//! The reduced symmetric top where its constants are equal or opposite, so that a quotient is 0 at its pole, on other scalars.

use lagrangian::Scalar;
use lagrangian::prelude::*;
use lagrangian_tests::{Dual, assert_close};

/// A symmetric top with parameters of any scalar.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(phi, theta, psi),
    define(w = angular_velocity_zxz(phi, theta, psi)),
    kinetic = 0.5 * w.dot(diagonal([i, i, i_s]) * w),
    potential = weight * cos(theta),
    routhian(ReducedTopOf, half_angles),
)]
#[allow(dead_code)] // Its reduced model is what is compared.
struct TopOf<T: Scalar> {
    i: T,
    i_s: T,
    weight: T,
}

/// Where `C_φ = ±C_ψ`, so that a quotient is 0 at its pole, it is not elsewhere: derivatives by `C_φ` on dual numbers.
#[test]
fn equal_constants_have_derivatives() {
    let [i, i_s, weight, p_phi] = [0.4, 0.1, 1.7, 3.0];
    for p_psi in [p_phi, -p_phi] {
        for theta in [1e-3, 0.4, -1.1, 1.6, 2.9, 3.1] {
            let top = ReducedTopOf {
                i: Dual::constant(i),
                i_s: Dual::constant(i_s),
                weight: Dual::constant(weight),
                p_phi: Dual::new(p_phi, 1.0),
                p_psi: Dual::constant(p_psi),
            };
            let still = Dual::constant(0.0);
            let state = State::new(still, [Dual::constant(theta)], [still]);
            let (s, c) = f64::sin_cos(0.5 * theta);
            let [lesser, greater] = [p_phi - p_psi, p_phi + p_psi];
            let precession = lesser / (4.0 * i * s * s) + greater / (4.0 * i * c * c);
            let slope = greater * s / c.powi(3) - lesser * c / s.powi(3);
            let (sine, cosine) = theta.sin_cos();
            let by_precession = 1.0 / (i * sine * sine);
            let found = [
                top.effective_potential(&state),
                top.energy(&state),
                -top.lagrangian(&state),
                top.ignorable_velocities(&state)[0],
                top.ignorable_velocities(&state)[1],
                top.accelerations(&state)[0],
            ];
            let expected = [
                precession,
                precession,
                precession,
                by_precession,
                -cosine * by_precession,
                -slope / (4.0 * i * i),
            ];
            for (found, expected) in found.into_iter().zip(expected) {
                let error = found.derivative() / expected - 1.0;
                assert_close("derivative", &[error], &[0.0], 1e-11);
            }
        }
    }
}

/// In single precision, too, the poles that equal constants remove are states like any other.
#[test]
fn single_precision_has_removable_poles() {
    let [i, i_s, weight, constant] = [0.4_f32, 0.1, 1.7, 3.0];
    for (theta, sign) in [
        (0.0_f32, 1.0_f32),
        (1e-30, 1.0),
        (core::f32::consts::PI, -1.0),
    ] {
        let top = ReducedTopOf {
            i,
            i_s,
            weight,
            p_phi: sign * constant,
            p_psi: constant,
        };
        let state = State::new(0.0, [theta], [0.0]);
        let potential = constant * constant / (2.0 * i_s) + sign * weight;
        let rates = top.ignorable_velocities(&state);
        let found = [
            top.effective_potential(&state),
            top.energy(&state),
            sign * rates[0] + rates[1],
            top.accelerations(&state)[0],
        ];
        let expected = [potential, potential, constant / i_s, 0.0];
        assert_close(
            "single",
            &found.map(f64::from),
            &expected.map(f64::from),
            1e-6,
        );
    }
}
