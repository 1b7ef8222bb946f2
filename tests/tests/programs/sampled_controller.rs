//! A pendulum under a PI-D controller that is sampled at 1 kHz, with an integral of its own, and held.

use lagrangian::prelude::*;

use crate::models::PENDULUM;

pub(crate) fn program() -> Result<f64, IntegrationError> {
    let held = Problem::new(&PENDULUM, State::new(0.0, [0.0], [0.0]));
    let held = held.sampled_feedback(1e-3, [0.0], |x, integral| {
        integral[0] += 1e-3 * (1.0 - x.q[0]);
        50.0 * (1.0 - x.q[0]) + 100.0 * integral[0] - 15.0 * x.v[0]
    });
    Ok(held.solve(10.0, Dop853::new())?.q[0])
}
