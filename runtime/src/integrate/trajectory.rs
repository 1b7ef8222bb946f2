//! Sampled motions. Needs the feature `alloc`.

use alloc::vec::Vec;
use core::fmt;

use super::at::At;
use super::dense_solution::DenseSolution;
use super::event::{MetConditions, Occurrence};
use super::outcome::{Outcome, StopReason};
use super::partial::Partial;
use super::stepper::Statistics;
use crate::number_format::Readable;

/// The samples of a motion, in the order of the requested times, its events, and its outcome. `S` is the scalar.
#[derive(Clone, Debug, PartialEq)]
pub struct Trajectory<X, S = f64> {
    pub(super) samples: Vec<At<f64, X>>,
    pub(super) events: Vec<Occurrence<X, S>>,
    pub(super) outcome: Outcome<X>,
}

impl<X, S> Trajectory<X, S> {
    /// The samples.
    #[must_use]
    pub fn samples(&self) -> &[At<f64, X>] {
        &self.samples
    }

    /// The samples, as a vector.
    #[must_use]
    pub fn into_initials(self) -> Vec<At<f64, X>> {
        self.samples
    }

    /// The events that occurred, in the order of time, simultaneous ones in the order of their indices.
    #[must_use]
    pub fn events(&self) -> &[Occurrence<X, S>] {
        &self.events
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
    pub fn last(&self) -> &At<f64, X> {
        &self.outcome.last
    }

    /// Why the integration stopped.
    #[must_use]
    pub fn reason(&self) -> StopReason {
        self.outcome.reason
    }

    /// Which stop conditions were met at its end, or which events occurred there.
    #[must_use]
    pub fn met(&self) -> MetConditions {
        self.outcome.met
    }

    /// How the integration ended.
    #[must_use]
    pub fn outcome(&self) -> &Outcome<X> {
        &self.outcome
    }

    /// Its cost.
    #[must_use]
    pub fn statistics(&self) -> Statistics {
        self.outcome.statistics
    }
}

/// An error that stopped an integration, with the trajectory up to then.
pub type PartialTrajectory<X, S = f64> = Partial<Trajectory<X, S>>;

/// An error that stopped an integration, with the solution up to then.
pub type PartialSolution<X, P, S = f64> = Partial<DenseSolution<X, P, S>>;

impl<X, P, S> Partial<DenseSolution<X, P, S>> {
    /// The solution up to the error.
    #[must_use]
    pub fn solution(&self) -> &DenseSolution<X, P, S> {
        self.value()
    }

    /// The solution up to the error, owned.
    #[must_use]
    pub fn into_solution(self) -> DenseSolution<X, P, S> {
        self.into_value()
    }
}

impl<X, S> Partial<Trajectory<X, S>> {
    /// The trajectory up to the error. Its [`last`](Trajectory::last) state is the last that was reached.
    #[must_use]
    pub fn trajectory(&self) -> &Trajectory<X, S> {
        self.value()
    }

    /// The trajectory up to the error, owned.
    #[must_use]
    pub fn into_trajectory(self) -> Trajectory<X, S> {
        self.into_value()
    }
}

impl<X, S> fmt::Display for Partial<Trajectory<X, S>> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let samples = self.trajectory().len();
        let plural = if samples == 1 { "" } else { "s" };
        write!(f, "{} (after {samples} sample{plural})", self.error())
    }
}

impl<X, P, S> fmt::Display for Partial<DenseSolution<X, P, S>> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (error, reached) = (self.error(), Readable(self.solution().last().t));
        write!(f, "{error} (the solution is known until t = {reached})")
    }
}
