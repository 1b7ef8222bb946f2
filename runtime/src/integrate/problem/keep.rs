//! The settings of what is kept of a motion.

use super::solution::Events;
use crate::integrate::at::At;
use crate::integrate::collector::{Collector, Uncollected};
use crate::integrate::dynamics::Dynamics;
use crate::integrate::error::IntegrationError;
#[cfg(feature = "alloc")]
use crate::integrate::event::Occurrence;
use crate::integrate::outcome::Outcome;
use crate::integrate::part::{KeptSoFar, Part};
use crate::integrate::sample_times::SampleTimes;
use crate::scalar::Scalar;

/// The types that [`Problem::save`](crate::Problem::save) accepts, for any problem.
#[diagnostic::on_unimplemented(
    message = "`{Self}` does not say what to keep of a motion",
    note = "write `Every(0.01)`, a list of times, `StepEnds` or `Dense`"
)]
pub trait Saved {}

impl Saved for End {}

/// The types that [`Problem::save`](crate::Problem::save) accepts for a problem.
#[diagnostic::on_unimplemented(
    message = "`{Self}` does not say what to keep of a motion",
    note = "write `Every(0.01)`, a list of times, `StepEnds` or `Dense`"
)]
pub trait Keep<S: Scalar, D: Dynamics<S>, T>: Saved + Sized {
    /// The type of what is kept.
    type Kept;
    /// The times of samples.
    #[doc(hidden)]
    type Times: SampleTimes;
    #[doc(hidden)]
    type Collection: Collector<S, D, T>;

    /// Whether steps are kept, or states within them.
    #[doc(hidden)]
    const READS_STEPS: bool = false;

    /// Returns the times of samples in a part of an integration, and the collector.
    #[doc(hidden)]
    fn begin(self, start: &At<f64, D::State>, part: Part) -> Begun<Self::Times, Self::Collection>;

    #[doc(hidden)]
    fn finish(collection: Self::Collection, outcome: &Outcome<D::State>) -> Self::Kept;
}

/// The beginning of a collection.
#[derive(Debug)]
pub struct Begun<T, C> {
    /// The times of samples.
    pub(super) times: T,
    pub(super) collection: C,
    /// An error if the settings are invalid.
    pub(super) checked: Result<(), IntegrationError>,
}

impl<T, C> Begun<T, C> {
    pub(super) fn valid(times: T, collection: C) -> Self {
        Self {
            times,
            collection,
            checked: Ok(()),
        }
    }
}

/// Keeps only the end.
#[derive(Clone, Copy, Debug)]
pub struct End;

impl<S: Scalar, D: Dynamics<S>, T> Keep<S, D, T> for End {
    type Kept = ();
    type Times = ();
    type Collection = Uncollected;

    fn begin(self, _: &At<f64, D::State>, _: Part) -> Begun<(), Uncollected> {
        Begun::valid((), Uncollected)
    }

    fn finish(_: Uncollected, _: &Outcome<D::State>) {}
}

/// The collector of a problem: what is kept, and the events.
pub(super) struct Collecting<'a, C, S, X> {
    pub(super) kept: &'a mut C,
    #[cfg_attr(not(feature = "alloc"), allow(dead_code))] // Unused without an allocator.
    pub(super) events: &'a mut Events<S, X>,
    pub(super) so_far: &'a mut KeptSoFar,
}

impl<S, D, T, C> Collector<S, D, T> for Collecting<'_, C, S, D::State>
where
    S: Scalar,
    D: Dynamics<S>,
    C: Collector<S, D, T>,
{
    fn sample(&mut self, sample: &At<f64, D::State>) {
        self.so_far.sample = Some(sample.t);
        self.kept.sample(sample);
    }

    #[cfg(feature = "alloc")]
    fn event(&mut self, (event, declared): (usize, Option<usize>), t: S, x: &D::State) {
        let x = x.clone();
        self.events.push(Occurrence {
            event,
            declared,
            state: At { t, x },
        });
    }

    fn step(&mut self, dynamics: &D, stepper: &mut T, end: f64) {
        self.so_far.step = Some(end);
        self.kept.step(dynamics, stepper, end);
    }
}
