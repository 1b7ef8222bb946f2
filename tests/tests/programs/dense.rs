//! A solution that is asked at any time.

use lagrangian::prelude::*;

use crate::models::{TOP, Top};

pub(crate) fn program() -> Result<[f64; 2], IntegrationError> {
    let start = State::new(0.0, [0.0, 0.5, 0.0], [0.0, 0.0, 20.0]);
    let motion = Problem::new(&TOP, start)
        .save(Dense)
        .solve(10.0, Taylor::new())?;
    Ok([
        motion.at(1.234)?.q[Top::THETA],
        motion.at(9.87)?.q[Top::THETA],
    ])
}
