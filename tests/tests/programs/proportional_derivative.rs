//! A pendulum that a PD controller holds at 1 rad.

use lagrangian::prelude::*;

use crate::models::PENDULUM;

pub(crate) fn program() -> Result<f64, IntegrationError> {
    let held = Problem::new(&PENDULUM, State::new(0.0, [0.0], [0.0]))
        .feedback(|x| -100.0 * (x.q[0] - 1.0) - 20.0 * x.v[0]);
    Ok(held.solve(10.0, Dop853::new())?.q[0])
}
