//! A pendulum that a PD controller holds at 1 rad.

use lagrangian::prelude::*;

use crate::models::PENDULUM;

pub(crate) fn program() -> Result<f64, IntegrationError> {
    let held = PENDULUM.controlled_by(|x| -100.0 * (x.q[0] - 1.0) - 20.0 * x.v[0]);
    let end = Dop853::new().integrate_to(&held, State::new(0.0, [0.0], [0.0]), 10.0)?;
    Ok(end.x.q[0])
}
