//! A long motion that reports its progress, and that another thread may cancel.

use std::sync::atomic::{AtomicBool, Ordering};

use lagrangian::prelude::*;

use crate::models::TOP;

pub(crate) fn program(
    cancelled: &AtomicBool,
    mut report: impl FnMut(f64),
) -> Result<f64, IntegrationError> {
    let start = State::new(0.0, [0.0, 0.5, 0.0], [0.3, 0.0, 20.0]);
    let motion = Problem::new(&TOP, start)
        .each_step(|progress| report(progress.fraction()))
        .stop_when(|_| cancelled.load(Ordering::Relaxed));
    Ok(motion.solve(100.0, Taylor::new())?.t)
}
