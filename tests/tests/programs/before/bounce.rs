//! A ball that loses half of its velocity at each bounce.

use lagrangian::prelude::*;

use crate::models::{BALL, Ball};

pub(crate) fn program() -> Result<Vec<f64>, IntegrationError> {
    let start = State::new(0.0, [0.0, 5.0], [1.0, 0.0]);
    let driver = Taylor::new()
        .driver()
        .declared_events([(Ball::FLOOR, Event::falling())]);
    let motion = driver.sample_reacting(&mut BALL.dynamics(), start, &[2.6], |_, _, x, _| {
        x.v[Ball::HEIGHT] *= -0.5;
        Reaction::Changed
    })?;
    Ok(motion.events().iter().map(|event| event.t).collect())
}
