//! A motion that is stored half-way, and goes on.

use lagrangian::prelude::*;

use crate::models::TOP;

pub(crate) fn program() -> Result<f64, IntegrationError> {
    let top = Problem::new(&TOP, State::new(0.0, [0.0, 0.5, 0.0], [0.0, 0.0, 20.0]));
    let mut run = top.clone().start(Taylor::new())?;
    run.advance(5.0)?;
    let stored = serde_json::to_string(&run.checkpoint()).expect("numbers are finite");
    let checkpoint = serde_json::from_str(&stored).expect("it was written so");
    Ok(top.resume(checkpoint, Taylor::new())?.advance(10.0)?.q[1])
}
