//! A pendulum under a torque that is a function of time, by Taylor series.

use lagrangian::prelude::*;
use lagrangian::signals::Sinusoid;

use crate::models::PENDULUM;

pub(crate) fn program() -> Result<f64, IntegrationError> {
    let driven =
        Problem::new(&PENDULUM, State::new(0.0, [0.0], [0.0])).driven_by([Sinusoid::new(0.5, 2.0)]);
    Ok(driven.solve(10.0, Taylor::new())?.q[0])
}
