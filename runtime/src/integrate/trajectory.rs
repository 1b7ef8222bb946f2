//! Sampled motions. Needs the feature `alloc`.

use alloc::{boxed::Box, vec::Vec};
use core::fmt;

use super::error::IntegrationError;
use super::outcome::{Outcome, StopReason};
use super::sample::Sample;
use super::stepper::Statistics;
use super::stop_condition::MetConditions;

/// The samples of a motion, in the order of the requested times, and its outcome.
#[derive(Clone, Debug, PartialEq)]
pub struct Trajectory<X> {
    pub(super) samples: Vec<Sample<X>>,
    pub(super) outcome: Outcome<X>,
}

impl<X> Trajectory<X> {
    /// The samples.
    #[must_use]
    pub fn samples(&self) -> &[Sample<X>] {
        &self.samples
    }

    /// The samples, as a vector.
    #[must_use]
    pub fn into_samples(self) -> Vec<Sample<X>> {
        self.samples
    }

    /// The number of samples.
    #[must_use]
    pub fn len(&self) -> usize {
        self.samples.len()
    }

    /// Whether there is no sample.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.samples.is_empty()
    }

    /// The last state that was reached without an error. It is the last sample unless something
    /// stopped the integration before the final time.
    #[must_use]
    pub fn last(&self) -> &Sample<X> {
        &self.outcome.last
    }

    /// Why the integration stopped.
    #[must_use]
    pub fn reason(&self) -> StopReason {
        self.outcome.reason
    }

    /// Which stop conditions were met at its end.
    #[must_use]
    pub fn met(&self) -> MetConditions {
        self.outcome.met
    }

    /// Its cost.
    #[must_use]
    pub fn statistics(&self) -> Statistics {
        self.outcome.statistics
    }
}

/// An error that stopped an integration, with the trajectory up to then.
#[derive(Clone, Debug, PartialEq)]
pub struct PartialTrajectory<X> {
    // One pointer, so that a `Result` is not large because of its error.
    parts: Box<(IntegrationError, Trajectory<X>)>,
}

impl<X> PartialTrajectory<X> {
    pub(super) fn new(error: IntegrationError, trajectory: Trajectory<X>) -> Self {
        Self {
            parts: Box::new((error, trajectory)),
        }
    }

    /// The error.
    #[must_use]
    pub fn error(&self) -> IntegrationError {
        self.parts.0
    }

    /// The trajectory up to the error. Its [`last`](Trajectory::last) state is the last that was reached.
    #[must_use]
    pub fn trajectory(&self) -> &Trajectory<X> {
        &self.parts.1
    }

    /// The trajectory up to the error, owned.
    #[must_use]
    pub fn into_trajectory(self) -> Trajectory<X> {
        self.parts.1
    }
}

impl<X> fmt::Display for PartialTrajectory<X> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let samples = self.trajectory().len();
        let plural = if samples == 1 { "" } else { "s" };
        write!(f, "{} (after {samples} sample{plural})", self.error())
    }
}

impl<X: fmt::Debug> core::error::Error for PartialTrajectory<X> {}

impl<X> From<PartialTrajectory<X>> for IntegrationError {
    fn from(partial: PartialTrajectory<X>) -> Self {
        partial.error()
    }
}
