//! A pendulum under a PI-D controller that is sampled at 1 kHz, with an integral of its own, and held.

use lagrangian::prelude::*;

use crate::models::PENDULUM;

pub(crate) fn program() -> Result<f64, IntegrationError> {
    let start = State::new(0.0, [0.0], [0.0]);
    let mut run = Problem::new(PENDULUM, start).start(Dop853::new())?;
    let mut integral = 0.0;
    for k in 1..=10_000 {
        run.change(|x, motor| {
            let error = 1.0 - x.q[0];
            integral += 1e-3 * error;
            let torque = 50.0 * error + 100.0 * integral - 15.0 * x.v[0];
            motor.change(|motor| motor.torque = torque);
        })?;
        run.advance(1e-3 * f64::from(k))?;
    }
    Ok(run.state().q[0])
}
