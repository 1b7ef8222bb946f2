//! How an integration ended.

use super::sample::Sample;
use super::stepper::Statistics;
use super::stop_condition::MetConditions;

/// Why an integration stopped.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum StopReason {
    /// The final time was reached.
    Completed,
    /// A stop condition was met.
    Condition,
    /// The observer stopped it.
    Observer,
    /// The steps that the driver allows at a time were taken ([`Driver::max_steps`](crate::Driver::max_steps)). It can go
    /// on from there.
    StepLimit,
    /// An error stopped it.
    Error,
}

/// How an integration ended: where, why, and at what cost.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Outcome<X> {
    /// The last state that was reached without an error.
    pub last: Sample<X>,
    /// Why it is the last.
    pub reason: StopReason,
    /// Which stop conditions were met there; none unless they are the reason.
    pub met: MetConditions,
    /// Its cost.
    pub statistics: Statistics,
}

impl<X> Outcome<X> {
    /// Before the first step.
    pub(crate) fn at(last: Sample<X>) -> Self {
        Self {
            last,
            reason: StopReason::Error,
            met: MetConditions::default(),
            statistics: Statistics::default(),
        }
    }
}
