//! A pendulum whose length is halved after 5 s.

use lagrangian::prelude::*;

use crate::models::Swing;

pub(crate) fn program() -> Result<f64, IntegrationError> {
    let start = State::new(0.0, [1.0], [0.0]);
    let half = Taylor::new().integrate_to(&Swing { l: 1.0, g: 9.81 }.dynamics(), start, 5.0)?;
    Ok(Taylor::new()
        .integrate_to(&Swing { l: 0.5, g: 9.81 }.dynamics(), &half, 10.0)?
        .x
        .q[0])
}
