//! A solution that is asked at any time.

use lagrangian::prelude::*;

use crate::models::TOP;

pub(crate) fn program() -> Result<[f64; 2], IntegrationError> {
    let top = Problem::new(&TOP, State::new(0.0, [0.0, 0.5, 0.0], [0.0, 0.0, 20.0]));
    let motion = top.save(Dense).solve(10.0, Taylor::new())?;
    Ok([motion.at(1.234)?.q[1], motion.at(9.87)?.q[1]])
}
