//! A game that draws sixty frames a second.

use lagrangian::prelude::*;

use crate::models::TOP;

pub(crate) fn program(mut draw: impl FnMut(f64)) -> Result<(), IntegrationError> {
    let start = State::new(0.0, [0.0, 0.5, 0.0], [0.0, 0.0, 20.0]);
    let dynamics = TOP.dynamics();
    let mut running = Taylor::new().driver().start(&dynamics, start)?;
    for frame in 1..=600 {
        running.advance_to(f64::from(frame) / 60.0)?;
        draw(running.state().q[1]);
    }
    Ok(())
}
