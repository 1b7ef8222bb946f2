//! A motion that is stored half-way, and goes on.

use lagrangian::prelude::*;

use crate::models::TOP;

pub(crate) fn program() -> Result<f64, IntegrationError> {
    let (dynamics, driver) = (TOP.dynamics(), Taylor::new().driver());
    let start = State::new(0.0, [0.0, 0.5, 0.0], [0.0, 0.0, 20.0]);
    let mut first = driver.clone().start(&dynamics, start)?;
    first.advance_to(5.0)?;
    let stored = serde_json::to_string(&first.checkpoint()).expect("numbers are finite");
    let checkpoint = serde_json::from_str(&stored).expect("it was written so");
    let mut second = driver.resume(&dynamics, checkpoint)?;
    Ok(second.advance_to(10.0)?.last.x.q[1])
}
