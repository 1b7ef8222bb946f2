//! A game that draws sixty frames a second.

use lagrangian::prelude::*;

use crate::models::TOP;

pub(crate) fn program(mut draw: impl FnMut(f64)) -> Result<(), IntegrationError> {
    let start = State::new(0.0, [0.0, 0.5, 0.0], [0.0, 0.0, 20.0]);
    let mut run = Problem::new(&TOP, start).start(Taylor::new())?;
    for frame in 1..=600 {
        draw(run.advance(f64::from(frame) / 60.0)?.q[1]);
    }
    Ok(())
}
