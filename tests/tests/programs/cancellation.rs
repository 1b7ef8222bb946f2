//! A long motion that reports its progress, and that another thread may cancel.

use std::sync::atomic::{AtomicBool, Ordering};

use lagrangian::prelude::*;

use crate::models::TOP;

pub(crate) fn program(
    cancelled: &AtomicBool,
    mut report: impl FnMut(f64),
) -> Result<f64, IntegrationError> {
    let top = Problem::new(&TOP, State::new(0.0, [0.0, 0.5, 0.0], [0.3, 0.0, 20.0]));
    let top = top.each_step(|progress| report(progress.fraction()));
    let top = top.stop_when(|_| cancelled.load(Ordering::Relaxed));
    Ok(top.solve(100.0, Taylor::new())?.t)
}
