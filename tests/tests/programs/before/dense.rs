//! A solution that is asked at any time.

use lagrangian::prelude::*;

use crate::models::{TOP, Top};

pub(crate) fn program() -> Result<[f64; 2], IntegrationError> {
    let start = State::new(0.0, [0.0, 0.5, 0.0], [0.0, 0.0, 20.0]);
    let solution = Taylor::new().driver().solve(&TOP.dynamics(), start, 10.0)?;
    Ok([
        solution.at(1.234)?.q[Top::THETA],
        solution.at(9.87)?.q[Top::THETA],
    ])
}
