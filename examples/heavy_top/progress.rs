//! How far a long integration has come.

use std::io::{self, IsTerminal, Write};
use std::time::{Duration, Instant};

/// How long a run is short: nothing is shown before.
const PATIENCE: Duration = Duration::from_secs(1);

/// The time between two looks of the bar.
const PAUSE: Duration = Duration::from_millis(100);

/// The length of the bar in characters.
const LENGTH: usize = 50;

/// A progress bar on standard error, which appears only in long runs and only on a terminal.
#[derive(Debug)]
pub(crate) struct ProgressBar {
    began: Instant,
    /// When the bar will be drawn again; never if it cannot be seen.
    due: Option<Instant>,
}

impl ProgressBar {
    /// Begins to wait.
    pub(crate) fn new() -> Self {
        let began = Instant::now();
        let due = io::stderr().is_terminal().then_some(began + PATIENCE);
        Self { began, due }
    }

    /// Shows that a part between 0 and 1 is done.
    pub(crate) fn show(&mut self, fraction: f64) {
        let Some(due) = self.due else { return };
        let now = Instant::now();
        if now >= due {
            self.due = Some(now + PAUSE);
            // A bar that cannot be drawn is not missed.
            let _ = write!(io::stderr(), "\r{}", bar(fraction, now - self.began));
        }
    }
}

impl Drop for ProgressBar {
    fn drop(&mut self) {
        // Drawn at least once.
        if self.due.is_some_and(|due| due > self.began + PATIENCE) {
            // Back to the start of the line, and clear it.
            let _ = write!(io::stderr(), "\r\x1b[2K");
        }
    }
}

/// The bar, the part done, and the time that is left at the pace so far.
fn bar(fraction: f64, elapsed: Duration) -> String {
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // From 0 to 100.
    let percent = (100.0 * fraction.clamp(0.0, 1.0)) as usize;
    let filled = percent * LENGTH / 100;
    let left = elapsed.as_secs_f64() * (1.0 / fraction.max(1e-6) - 1.0);
    format!(
        "Integrating {}{} {percent:3} %, {left:.0} s left   ",
        "█".repeat(filled),
        "░".repeat(LENGTH - filled)
    )
}

#[cfg(test)]
mod tests {
    use std::time::Duration;

    use super::bar;

    #[test]
    fn bar_fills_and_time_runs_out() {
        let at = |fraction| bar(fraction, Duration::from_secs(6));
        assert!(at(0.0).contains(" ░░░"));
        assert!(at(0.6).ends_with("░  60 %, 4 s left   "));
        assert!(at(1.0).ends_with("█ 100 %, 0 s left   "));
        assert_eq!(at(0.3).chars().filter(|c| *c == '█').count(), 15);
    }
}
