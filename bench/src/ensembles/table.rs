//! The table of the methods that integrate an ensemble.

use std::fmt::Write as _;

use super::errors::Errors;

/// One method.
pub(super) struct Line {
    pub(super) name: String,
    pub(super) tolerance: f64,
    pub(super) errors: Errors,
    pub(super) steps: u64,
    pub(super) seconds: f64,
    pub(super) motions: usize,
}

/// Steps and times are for each motion.
pub(super) fn table(lines: &[Line]) -> String {
    let mut table = format!(
        "  {:<52} {:>9} {:>9} {:>9} {:>7} {:>8}\n",
        "", "tolerance", "error", "largest", "steps", "µs"
    );
    for line in lines {
        #[allow(clippy::cast_precision_loss)] // Counts.
        let (steps, motions) = (line.steps as f64, line.motions as f64);
        let Errors {
            percentile,
            largest,
        } = line.errors;
        let _ = writeln!(
            table,
            "  {:<52} {:>9.1e} {percentile:>9.2e} {largest:>9.1e} {:>7.1} {:>8.2}",
            line.name,
            line.tolerance,
            steps / motions,
            line.seconds * 1e6 / motions,
        );
    }
    table
}
