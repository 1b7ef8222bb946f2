//! A throw: an event that stops and another that is recorded.

use lagrangian::prelude::*;

use crate::models::{BALL, Ball};

pub(crate) fn program() -> Result<[f64; 2], IntegrationError> {
    let throw = Problem::new(&BALL, State::new(0.0, [0.0, 0.0], [1.0, 20.0]));
    let throw = throw.on(Ball::FLOOR).falling().stop();
    let flight = throw.on(Ball::APEX).record().solve(10.0, Taylor::new())?;
    Ok([flight.events()[0].x.q[Ball::HEIGHT], flight.q[Ball::X]])
}
