//! The nutation of a top, sampled every 10 ms.

use lagrangian::prelude::*;

use crate::models::{TOP, Top};

pub(crate) fn program() -> Result<Vec<f64>, IntegrationError> {
    let start = State::new(0.0, [0.0, 0.5, 0.0], [0.0, 0.0, 20.0]);
    let times: Vec<f64> = (0..=1000).map(|k| 0.01 * f64::from(k)).collect();
    let motion = Taylor::new().sample(&TOP.dynamics(), start, &times)?;
    Ok(motion.states().map(|state| state.q[Top::THETA]).collect())
}
