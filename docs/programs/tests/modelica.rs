//! The equations of the page on Modelica, which is not run, are those of the model.

use lagrangian::prelude::*;
use lagrangian_guide::furuta::Furuta;

#[test]
fn equations_of_the_page_hold() {
    let model = Furuta {
        j: 3e-3,
        m: 0.2,
        r: 0.25,
        l: 0.3,
        g: 9.81,
        d_alpha: 2e-3,
        d_theta: 5e-4,
        torque: 0.05,
    };
    let Furuta { j, m, r, l, g, .. } = model;
    let state = State::new(0.0, [0.7, 1.1], [2.0, -3.0]);
    let [alpha_rate, theta_rate] = [state.v[0], state.v[1]];
    let accelerations = model.accelerations(&state);
    let (sin, cos) = state.q[1].sin_cos();
    let inertia = m * l.powi(2);
    let arm = (j + m * r.powi(2) + inertia * sin.powi(2)) * accelerations[0]
        + m * r * l * cos * accelerations[1]
        + 2.0 * inertia * sin * cos * alpha_rate * theta_rate
        - m * r * l * sin * theta_rate.powi(2);
    let rod = m * r * l * cos * accelerations[0] + inertia * accelerations[1]
        - inertia * sin * cos * alpha_rate.powi(2)
        + m * g * l * sin;
    assert!((arm - (model.torque - model.d_alpha * alpha_rate)).abs() < 1e-13);
    assert!((rod + model.d_theta * theta_rate).abs() < 1e-13);
}
