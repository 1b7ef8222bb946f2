//! The table of a contest.

use std::fmt::Write as _;

/// One method of one side.
pub(super) struct Line {
    pub(super) name: String,
    pub(super) seconds: f64,
    /// Ours compiled with default flags; not a number for others.
    pub(super) with_default_flags: f64,
    /// Integrated at once.
    pub(super) motions: usize,
    pub(super) steps: u64,
    pub(super) error: f64,
    pub(super) drift: Option<f64>,
}

/// Times are for each motion.
pub(super) fn table(lines: &[Line]) -> String {
    let mut table = format!(
        "  {:<32} {:>12} {:>18} {:>8} {:>10} {:>9} {:>13}\n",
        "", "native, ms", "default flags, ms", "steps", "ns a step", "error", "energy drift"
    );
    for line in lines {
        #[allow(clippy::cast_precision_loss)] // Counts.
        let (steps, motions) = (line.steps as f64, line.motions as f64);
        let default = line.with_default_flags * 1e3 / motions;
        let default = if default.is_nan() {
            "-".to_owned()
        } else {
            format!("{default:.2}")
        };
        let _ = writeln!(
            table,
            "  {:<32} {:>12.2} {:>18} {:>8} {:>10.0} {:>9.0e} {:>13}",
            line.name,
            line.seconds * 1e3 / motions,
            default,
            line.steps,
            line.seconds * 1e9 / steps / motions,
            line.error,
            line.drift
                .map_or("-".to_owned(), |drift| format!("{drift:.0e}")),
        );
    }
    table
}
