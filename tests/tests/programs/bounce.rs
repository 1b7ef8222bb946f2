//! A ball that loses half of its velocity at each bounce.

use lagrangian::prelude::*;

use crate::models::{BALL, Ball};

pub(crate) fn program() -> Result<Vec<f64>, IntegrationError> {
    let motion = Problem::new(&BALL, State::new(0.0, [0.0, 5.0], [1.0, 0.0]))
        .on(Ball::FLOOR)
        .falling()
        .then(|ball| ball.v[Ball::HEIGHT] *= -0.5)
        .solve(2.6, Taylor::new())?;
    Ok(motion.events().iter().map(|event| event.t).collect())
}
