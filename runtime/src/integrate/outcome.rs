//! How an integration ended.

use super::at::At;
use super::event::MetConditions;
use super::stepper::Statistics;

/// Why an integration stopped.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum StopReason {
    /// The final time was reached.
    Completed,
    /// A stop condition was met, a terminal event occurred, or a reaction ended it.
    Condition,
    /// The integration ended **before the final time**, since an event has occurred again and again in too short a time (Zeno
    /// behaviour): a ball whose bounces have become so short is at rest. [`Problem::solve`](crate::Problem::solve) returns `Ok` there,
    /// too. More than eight times in a row the event came, and the method began anew, within 1024 times what
    /// is resolved, 100 ε (|t| + h) after steps of the length h; or within an eighth of the step where its function does
    /// not leave its rounding errors; or twice where it does not leave zero.
    Zeno,
    /// An observer stopped it.
    Observer,
    /// As many steps were taken as are allowed at a time ([`Problem::max_steps`](crate::Problem::max_steps)). It can go on from
    /// there.
    StepLimit,
    /// An error stopped it.
    Error,
}

/// How an integration ended: where, why, and at what cost.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Outcome<X> {
    /// The last state that was reached without an error.
    pub last: At<f64, X>,
    /// Why it is the last.
    pub reason: StopReason,
    /// Which stop conditions were met there, or which events occurred, or which observers stopped: those that are the reason,
    /// numbered in the order in which they were set, and none for another reason.
    pub met: MetConditions,
    /// Its cost.
    pub statistics: Statistics,
}

impl<X> Outcome<X> {
    /// Before the first step.
    pub(crate) fn at(last: At<f64, X>) -> Self {
        Self {
            last,
            reason: StopReason::Error,
            met: MetConditions::default(),
            statistics: Statistics::default(),
        }
    }
}
