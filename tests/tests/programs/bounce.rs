//! A ball that loses half of its velocity at each bounce.

use lagrangian::prelude::*;

use crate::models::{BALL, Ball};

pub(crate) fn program() -> Result<Vec<f64>, IntegrationError> {
    let ball = Problem::new(&BALL, State::new(0.0, [0.0, 5.0], [1.0, 0.0]));
    let ball = ball.on(Ball::FLOOR).falling().then(|x| x.v[1] *= -0.5);
    let motion = ball.solve(2.6, Taylor::new())?;
    Ok(motion.events().iter().map(|event| event.t).collect())
}
