//! A pendulum under a torque that is a function of time, by Taylor series.

use lagrangian::Sinusoid;
use lagrangian::prelude::*;

use crate::models::PENDULUM;

pub(crate) fn program() -> Result<f64, IntegrationError> {
    let torque = Sinusoid {
        amplitude: 0.5,
        angular_frequency: 2.0,
        phase: 0.0,
    };
    let driven = PENDULUM.driven_by([torque]);
    Ok(Taylor::new()
        .integrate_to(&driven, State::new(0.0, [0.0], [0.0]), 10.0)?
        .x
        .q[0])
}
