//! The settings of what is kept of a motion.

#[cfg(feature = "alloc")]
use alloc::vec::Vec;

use super::solution::Events;
use crate::integrate::at::At;
use crate::integrate::collector::{Collector, Uncollected};
#[cfg(feature = "alloc")]
use crate::integrate::dense_output::DenseOutput;
#[cfg(feature = "alloc")]
use crate::integrate::dense_solution::{DenseSolution, Segments};
use crate::integrate::dynamics::Dynamics;
use crate::integrate::error::IntegrationError;
#[cfg(feature = "alloc")]
use crate::integrate::event::Occurrence;
use crate::integrate::outcome::Outcome;
use crate::integrate::part::{KeptSoFar, Part};
use crate::integrate::sample_times::SampleTimes;
#[cfg(feature = "alloc")]
use crate::integrate::sample_times::{ListedTimes, TimeGrid};
#[cfg(feature = "alloc")]
use crate::integrate::stepper::Advance;
use crate::scalar::Scalar;

/// The types that [`Problem::save`](crate::Problem::save) accepts, for any problem.
#[diagnostic::on_unimplemented(
    message = "`{Self}` does not say what to keep of a motion",
    note = "write `Every(0.01)`, a list of times, `StepEnds` or `Dense`"
)]
pub trait Saved {}

impl Saved for End {}

#[cfg(feature = "alloc")]
mod saved {
    use super::{Dense, Every, Saved, StepEnds, Vec};

    impl Saved for Every {}
    impl Saved for StepEnds {}
    impl Saved for Dense {}
    impl Saved for Vec<f64> {}
    impl Saved for &Vec<f64> {}
    impl Saved for &[f64] {}
    impl<const N: usize> Saved for [f64; N] {}
    impl<const N: usize> Saved for &[f64; N] {}
}

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
    fn valid(times: T, collection: C) -> Self {
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

/// Samples at the start and at regular intervals: at t₀, t₀ + Δt, … up to the end.
///
/// The parts of a [`Run`](crate::problem::Run) share this grid, and each sample is kept by one of them.
#[cfg(feature = "alloc")]
#[derive(Clone, Copy, Debug)]
pub struct Every(pub f64);

/// Samples at the start and at the end of each step; each is kept by one part of a [`Run`](crate::problem::Run).
#[cfg(feature = "alloc")]
#[derive(Clone, Copy, Debug)]
pub struct StepEnds;

/// The whole motion, which can be evaluated at any time: `solution.at(t)`.
///
/// Between the ends of steps a state is on the manifold of the [dynamics](crate::Dynamics::project) within the
/// tolerance; samples are projected onto it.
#[cfg(feature = "alloc")]
#[derive(Clone, Copy, Debug)]
pub struct Dense;

/// The states at the sample times.
#[cfg(feature = "alloc")]
#[derive(Debug)]
pub struct Samples<S, X>(Vec<At<S, X>>);

#[cfg(feature = "alloc")]
impl<S: Scalar, D: Dynamics<S>, T> Collector<S, D, T> for Samples<S, D::State> {
    fn sample(&mut self, sample: &At<f64, D::State>) {
        self.0.push(sample.clone().on_scalar());
    }
}

#[cfg(feature = "alloc")]
impl<S, D, T> Keep<S, D, T> for Vec<f64>
where
    S: Scalar,
    D: Dynamics<S>,
{
    type Kept = Vec<At<S, D::State>>;
    type Times = ListedTimes;
    type Collection = Samples<S, D::State>;

    fn begin(self, start: &At<f64, D::State>, part: Part) -> Begun<Self::Times, Self::Collection> {
        let collection = Samples(Vec::with_capacity(self.len()));
        let (times, checked) = ListedTimes::of(self, start.t, part);
        Begun {
            times,
            collection,
            checked,
        }
    }

    fn finish(collection: Samples<S, D::State>, _: &Outcome<D::State>) -> Self::Kept {
        collection.0
    }
}

/// Implements `Keep` for other lists of times.
#[cfg(feature = "alloc")]
macro_rules! lists_of_times {
    ($([$($parameter:tt)*] $list:ty;)*) => {$(
        impl<S: Scalar, D: Dynamics<S>, T, $($parameter)*> Keep<S, D, T> for $list {
            type Kept = Vec<At<S, D::State>>;
            type Times = ListedTimes;
            type Collection = Samples<S, D::State>;

            fn begin(self, start: &At<f64, D::State>, part: Part) -> Begun<ListedTimes, Self::Collection> {
                Keep::<S, D, T>::begin(self.to_vec(), start, part)
            }

            fn finish(collection: Self::Collection, _: &Outcome<D::State>) -> Self::Kept {
                collection.0
            }
        }
    )*};
}

#[cfg(feature = "alloc")]
lists_of_times! {
    [] &[f64];
    [] &Vec<f64>;
    [const N: usize] [f64; N];
    [const N: usize] &[f64; N];
}

#[cfg(feature = "alloc")]
impl<S: Scalar, D: Dynamics<S>, T> Keep<S, D, T> for Every {
    type Kept = Vec<At<S, D::State>>;
    type Times = TimeGrid;
    type Collection = Samples<S, D::State>;

    fn begin(self, start: &At<f64, D::State>, part: Part) -> Begun<TimeGrid, Self::Collection> {
        let (Self(interval), end) = (self, part.end);
        // The interval has to be above the resolution of times. Times that are not finite are refused together with the
        // end.
        let largest = start.t.abs().max(end.abs()).max(part.origin.abs());
        let resolution = 16.0 * f64::EPSILON * largest;
        let is_resolved = interval > resolution || resolution.is_infinite();
        let is_valid = interval > 0.0 && interval.is_finite() && is_resolved;
        Begun {
            times: TimeGrid::of(interval, start.t, part),
            collection: Samples(Vec::new()),
            checked: if is_valid {
                Ok(())
            } else {
                Err(IntegrationError::InvalidSampleInterval { interval })
            },
        }
    }

    fn finish(collection: Self::Collection, _: &Outcome<D::State>) -> Self::Kept {
        collection.0
    }
}

/// The ends of steps.
#[cfg(feature = "alloc")]
#[derive(Debug)]
pub struct CollectedSteps<S, X>(Vec<At<S, X>>);

#[cfg(feature = "alloc")]
impl<S, D, T> Collector<S, D, T> for CollectedSteps<S, D::State>
where
    S: Scalar,
    D: Dynamics<S>,
    T: Advance<S, D>,
{
    fn step(&mut self, dynamics: &D, stepper: &mut T, end: f64) {
        let x = if end - stepper.time() == 0.0 {
            stepper.state().clone()
        } else {
            stepper.interpolate(dynamics, end)
        };
        self.0.push(At {
            t: S::from_f64(end),
            x,
        });
    }
}

#[cfg(feature = "alloc")]
impl<S, D, T> Keep<S, D, T> for StepEnds
where
    S: Scalar,
    D: Dynamics<S>,
    T: Advance<S, D>,
{
    type Kept = Vec<At<S, D::State>>;
    type Times = ();
    type Collection = CollectedSteps<S, D::State>;

    const READS_STEPS: bool = true;

    fn begin(self, start: &At<f64, D::State>, part: Part) -> Begun<(), Self::Collection> {
        // The end of the previous part is not kept again.
        let is_kept = part.kept.step.is_some_and(|t| t - start.t == 0.0);
        let first = (!is_kept).then(|| start.clone().on_scalar());
        Begun::valid((), CollectedSteps(first.into_iter().collect()))
    }

    fn finish(collection: Self::Collection, _: &Outcome<D::State>) -> Self::Kept {
        collection.0
    }
}

/// The polynomials of the steps, starting from an initial state.
#[cfg(feature = "alloc")]
pub struct Whole<X, P> {
    initial: At<f64, X>,
    segments: Segments<P>,
}

#[cfg(feature = "alloc")]
impl<S, D, T> Collector<S, D, T> for Whole<D::State, T::Interpolant>
where
    S: Scalar,
    D: Dynamics<S>,
    T: DenseOutput<S, D>,
{
    fn step(&mut self, dynamics: &D, stepper: &mut T, end: f64) {
        self.segments.step(dynamics, stepper, end);
    }
}

#[cfg(feature = "alloc")]
impl<S, D, T> Keep<S, D, T> for Dense
where
    S: Scalar,
    D: Dynamics<S>,
    T: DenseOutput<S, D>,
{
    type Kept = DenseSolution<D::State, T::Interpolant, S>;
    type Times = ();
    type Collection = Whole<D::State, T::Interpolant>;

    const READS_STEPS: bool = true;

    fn begin(self, start: &At<f64, D::State>, _: Part) -> Begun<(), Self::Collection> {
        let whole = Whole {
            initial: start.clone(),
            segments: Segments::new(),
        };
        Begun::valid((), whole)
    }

    fn finish(collection: Self::Collection, outcome: &Outcome<D::State>) -> Self::Kept {
        DenseSolution::new(
            collection.initial,
            collection.segments,
            outcome.last.clone(),
        )
    }
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
