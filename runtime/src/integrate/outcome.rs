//! How an integration ended.

use super::sample::Sample;
use super::stepper::Statistics;
use super::stop_condition::MetConditions;

/// Why an integration ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum StopReason {
    /// The end was reached.
    Completed,
    /// The condition to stop on was met.
    Condition,
    /// The observer stopped it.
    Observer,
    /// An error stopped it.
    Error,
}

/// Where and how an integration ended.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Outcome<X> {
    /// The last state that was reached without an error.
    pub last: Sample<X>,
    /// Why it is the last.
    pub reason: StopReason,
    /// Which conditions to stop on were met there; none unless they are the reason.
    pub met: MetConditions,
    /// What it has cost.
    pub statistics: Statistics,
}
