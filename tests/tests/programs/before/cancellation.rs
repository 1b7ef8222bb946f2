//! A long motion that reports its progress, and that another thread may cancel.

use std::ops::ControlFlow;
use std::sync::atomic::{AtomicBool, Ordering};

use lagrangian::prelude::*;

use crate::models::TOP;

pub(crate) fn program(
    cancelled: &AtomicBool,
    mut report: impl FnMut(f64),
) -> Result<f64, IntegrationError> {
    let start = State::new(0.0, [0.0, 0.5, 0.0], [0.3, 0.0, 20.0]);
    let driver = Taylor::new()
        .driver()
        .observe(|progress: &Progress<'_, Phase<f64, 3>>| {
            report(progress.t / 100.0);
            if cancelled.load(Ordering::Relaxed) {
                return ControlFlow::Break(());
            }
            ControlFlow::Continue(())
        });
    Ok(driver.run_until(&TOP.dynamics(), start, 100.0)?.last.t)
}
