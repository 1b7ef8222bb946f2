//! A throw: an event that stops and another that is recorded.

use lagrangian::prelude::*;

use crate::models::{BALL, Ball};

pub(crate) fn program() -> Result<[f64; 2], IntegrationError> {
    let start = State::new(0.0, [0.0, 0.0], [1.0, 20.0]);
    let events = [
        (Ball::FLOOR, Event::falling().terminal()),
        (Ball::APEX, Event::falling()),
    ];
    let driver = Taylor::new().driver().declared_events(events);
    let flight = driver.sample(&BALL.dynamics(), start, &[10.0])?;
    Ok([
        flight.events()[0].x.q[Ball::HEIGHT],
        flight.last().x.q[Ball::X],
    ])
}
