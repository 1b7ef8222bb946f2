//! A motion that is stored half-way, and goes on.

use lagrangian::prelude::*;

use crate::models::TOP;

pub(crate) fn program() -> Result<f64, IntegrationError> {
    let problem = Problem::new(&TOP, State::new(0.0, [0.0, 0.5, 0.0], [0.0, 0.0, 20.0]));
    let mut first = problem.clone().start(Taylor::new())?;
    first.advance(5.0)?;
    let stored = serde_json::to_string(&first.checkpoint()).expect("numbers are finite");
    let checkpoint = serde_json::from_str(&stored).expect("it was written so");
    let mut second = problem.resume(checkpoint, Taylor::new())?;
    Ok(second.advance(10.0)?.q[1])
}
