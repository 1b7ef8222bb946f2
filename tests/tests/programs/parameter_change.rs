//! A pendulum whose length is halved after 5 s.

use lagrangian::prelude::*;

use crate::models::Swing;

pub(crate) fn program() -> Result<f64, IntegrationError> {
    let swing = |l, start, end| Problem::new(Swing { l, g: 9.81 }, start).solve(end, Taylor::new());
    let half = swing(1.0, State::new(0.0, [1.0], [0.0]), 5.0)?;
    Ok(swing(0.5, half.last, 10.0)?.q[0])
}
