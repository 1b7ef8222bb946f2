//! What the spellings are compared with: Euler's equations, at states anywhere and near the poles.

use lagrangian::nalgebra::{Matrix3, Vector3};
use lagrangian::prelude::*;
use lagrangian_tests::{Figures, Random, list, numbers};

use super::{CENTER, G, M, PRINCIPAL, PRODUCTS};

/// Comparisons with Euler's equations for one body.
pub(super) struct Check {
    inertia: Matrix3<f64>,
    tolerance: f64,
    pub(super) figures: Figures,
}

impl Check {
    pub(super) fn new(inertia: &Matrix3<f64>, tolerance: f64) -> Self {
        Self {
            inertia: *inertia,
            tolerance,
            figures: Figures::new(),
        }
    }

    /// The error of q̈, in relation to its length.
    pub(super) fn compare(
        &mut self,
        name: &'static str,
        model: &impl Lagrangian<3>,
        states: &[State<f64, 3>],
    ) {
        for state in states {
            let expected = euler(&self.inertia, state);
            let error = (model.accelerations(state) - expected).norm() / expected.norm();
            self.figures
                .record(name, &format!("{state:?}"), error, self.tolerance);
        }
    }
}

/// A tensor of inertia (2.1) about axes that are not principal.
pub(super) fn tensor() -> Matrix3<f64> {
    let ([ixx, iyy, izz], [ixy, ixz, iyz]) = (PRINCIPAL, PRODUCTS);
    Matrix3::new(ixx, -ixy, -ixz, -ixy, iyy, -iyz, -ixz, -iyz, izz)
}

pub(super) fn anywhere() -> Vec<State<f64, 3>> {
    let mut random = Random::default();
    let states = std::iter::repeat_with(|| random.state());
    states
        .filter(|state| state.q[1].sin().abs() > 0.01)
        .take(500)
        .collect()
}

pub(super) fn near_the_poles() -> Vec<State<f64, 3>> {
    references().into_iter().map(|(state, _)| state).collect()
}

/// States near the poles, and the accelerations of the body with principal axes, of 40 digits.
pub(super) fn references() -> Vec<(State<f64, 3>, Vector3<f64>)> {
    let references = lagrangian_tests::near_the_poles();
    let inclinations = references["general"]["theta"].as_object();
    let cases = inclinations
        .expect("cases by inclination")
        .values()
        .flat_map(list);
    let vector = |value| Vector3::from_vec(numbers(value));
    cases
        .map(|case| {
            let state = State::new(0.0, vector(&case["q"]), vector(&case["qd"]));
            (state, vector(&case["qdd"]))
        })
        .collect()
}

/// Euler's equations I ω̇ + ω × I ω = N, with the moment of the weight, solved for the angles by the
/// inverse of (4.4).
pub(super) fn euler(inertia: &Matrix3<f64>, state: &State<f64, 3>) -> Vector3<f64> {
    let [phi_dot, theta_dot, psi_dot] = state.v.into();
    let ((st, ct), (sp, cp)) = (state.q[1].sin_cos(), state.q[2].sin_cos());
    let vertical = Vector3::new(st * sp, st * cp, ct);
    let w = phi_dot * vertical + Vector3::new(theta_dot * cp, -theta_dot * sp, psi_dot);
    let moment = -M * G * Vector3::from(CENTER).cross(&vertical);
    let inverse = inertia.try_inverse().expect("a body has an inertia");
    let rate = inverse * (moment - w.cross(&(inertia * w)));
    // What is left for φ̈, θ̈ and ψ̈ of the rates of ω: the vertical turns by −ω × vertical.
    let line_of_nodes = Vector3::new(-sp, -cp, 0.0) * (theta_dot * psi_dot);
    let [b1, b2, b3] = (rate + phi_dot * w.cross(&vertical) - line_of_nodes).into();
    let phi = (b1 * sp + b2 * cp) / st;
    Vector3::new(phi, b1 * cp - b2 * sp, b3 - phi * ct)
}
