//! A pendulum under a PI-D controller that is sampled at 1 kHz, with an integral of its own, and held.

use lagrangian::prelude::*;

use crate::models::PENDULUM;

pub(crate) fn program() -> Result<f64, IntegrationError> {
    let (mut motor, mut integral) = (PENDULUM, 0.0);
    let mut state = State::new(0.0, [0.0], [0.0]);
    for k in 1..=10_000 {
        let error = 1.0 - state.q[0];
        integral += 1e-3 * error;
        motor.torque = 50.0 * error + 100.0 * integral - 15.0 * state.v[0];
        let end = 1e-3 * f64::from(k);
        state = Dop853::new()
            .integrate_to(&motor.dynamics(), state, end)?
            .state();
    }
    Ok(state.q[0])
}
