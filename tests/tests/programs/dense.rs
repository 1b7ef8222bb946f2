//! A solution that is asked at any time.

use lagrangian::prelude::*;

use crate::models::{TOP, Top};

pub(crate) fn program() -> Result<[f64; 2], IntegrationError> {
    let top = Problem::new(&TOP, State::new(0.0, [0.0, 0.5, 0.0], [0.0, 0.0, 20.0]));
    let motion = top.save(Dense).solve(10.0, Taylor::new())?;
    let theta = |t| motion.at(t).map(|state| state.q[Top::THETA]);
    Ok([theta(1.234)?, theta(9.87)?])
}
