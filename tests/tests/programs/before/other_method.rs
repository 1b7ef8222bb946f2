//! The top by another method.

use lagrangian::prelude::*;

use crate::models::TOP;

pub(crate) fn program() -> Result<f64, IntegrationError> {
    let start = State::new(0.0, [0.0, 0.5, 0.0], [0.3, 0.0, 20.0]);
    let end = Dop853::new()
        .integrate_to(&TOP.dynamics(), start, 10.0)?
        .state();
    Ok(TOP.energy(&end) / TOP.energy(&start) - 1.0)
}
