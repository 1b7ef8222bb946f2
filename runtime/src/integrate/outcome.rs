//! The outcome of an integration.

use super::at::At;
use super::event::MetConditions;

/// The reason for which an integration stopped.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum StopReason {
    /// The final time was reached.
    Completed,
    /// A stop condition was met, a terminal event occurred, or a reaction ended it.
    Condition,
    /// The integration ended **before the final time**, because an event recurred in too short a time (Zeno behaviour):
    /// a ball whose bounces have become that short is at rest. [`Problem::solve`](crate::Problem::solve) returns `Ok`
    /// in this case, too.
    ///
    /// The event, with a restart of the method, occurred more than eight times in a row, each time within 1024 times
    /// the resolution of time, which is 100 ε (|t| + h) after steps of length h. If the event's function does not leave
    /// its rounding errors in between, each time within an eighth of the step is enough; if it does not leave zero, two
    /// occurrences are enough.
    Zeno,
    /// An observer stopped it.
    Observer,
    /// The largest number of steps at a time ([`Problem::max_steps`](crate::Problem::max_steps)) was taken. The
    /// integration can be continued.
    StepLimit,
    /// An error stopped it.
    Error,
}

/// The outcome of an integration: the last state and the reason to stop.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Outcome<X> {
    /// The last state that was reached without an error.
    pub last: At<f64, X>,
    /// The reason for which it is the last state.
    pub reason: StopReason,
    /// The stop conditions that were met, the events that occurred, or the observers that stopped the integration, if
    /// they are the reason. They are numbered in the order in which they were set. Empty for any other reason.
    pub met: MetConditions,
}

impl<X> Outcome<X> {
    /// Creates the outcome before the first step.
    pub(crate) fn at(last: At<f64, X>) -> Self {
        Self {
            last,
            reason: StopReason::Error,
            met: MetConditions::default(),
        }
    }
}
