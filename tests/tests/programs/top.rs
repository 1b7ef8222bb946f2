//! A top, for 10 s.

use lagrangian::prelude::*;

use crate::models::TOP;

pub(crate) fn program() -> Result<f64, IntegrationError> {
    let start = State::new(0.0, [0.0, 0.5, 0.0], [0.3, 0.0, 20.0]);
    let end = Problem::new(&TOP, start).solve(10.0, Taylor::new())?;
    Ok(TOP.energy(&end) / TOP.energy(&start) - 1.0)
}
