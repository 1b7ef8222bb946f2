//! The nutation of a top, sampled every 10 ms.

use lagrangian::prelude::*;

use crate::models::{TOP, Top};

pub(crate) fn program() -> Result<Vec<f64>, IntegrationError> {
    let top = Problem::new(&TOP, State::new(0.0, [0.0, 0.5, 0.0], [0.0, 0.0, 20.0]));
    let motion = top.save(Every(0.01)).solve(10.0, Taylor::new())?;
    Ok(motion.into_iter().map(|x| x.q[Top::THETA]).collect())
}
