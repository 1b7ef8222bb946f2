//! States that are kept of a motion: samples, and the ends of steps. Needs the feature `alloc`.

use alloc::vec::Vec;

use super::keep::{Begun, Keep, Saved};
use crate::integrate::at::At;
use crate::integrate::collector::Collector;
use crate::integrate::dynamics::Dynamics;
use crate::integrate::error::IntegrationError;
use crate::integrate::outcome::Outcome;
use crate::integrate::part::Part;
use crate::integrate::sample_times::{ListedTimes, TimeGrid};
use crate::integrate::stepper::Advance;
use crate::scalar::Scalar;

/// Samples at the start and at regular intervals: at t₀, t₀ + Δt, … up to the end.
///
/// The parts of a [`Run`](crate::problem::Run) share this grid, and each sample is kept by one of them.
#[derive(Clone, Copy, Debug)]
pub struct Every(pub f64);

/// Samples at the start and at the end of each step; each is kept by one part of a [`Run`](crate::problem::Run).
#[derive(Clone, Copy, Debug)]
pub struct StepEnds;

impl Saved for Every {}
impl Saved for StepEnds {}

/// The states at the sample times.
#[derive(Debug)]
pub struct Samples<S, X>(Vec<At<S, X>>);

impl<S: Scalar, D: Dynamics<S>, T> Collector<S, D, T> for Samples<S, D::State> {
    fn sample(&mut self, sample: &At<f64, D::State>) {
        self.0.push(sample.clone().on_scalar());
    }
}

/// Implements `Keep` for lists of times, which a method takes as a vector.
macro_rules! lists_of_times {
    ($([$($parameter:tt)*] $list:ty, $into_vector:ident;)*) => {$(
        impl<$($parameter)*> Saved for $list {}

        impl<S: Scalar, D: Dynamics<S>, T, $($parameter)*> Keep<S, D, T> for $list {
            type Kept = Vec<At<S, D::State>>;
            type Times = ListedTimes;
            type Collection = Samples<S, D::State>;

            fn begin(self, start: &At<f64, D::State>, part: Part) -> Begun<ListedTimes, Self::Collection> {
                let collection = Samples(Vec::with_capacity(self.len()));
                let (times, checked) = ListedTimes::of(self.$into_vector(), start.t, part);
                Begun {
                    times,
                    collection,
                    checked,
                }
            }

            fn finish(collection: Self::Collection, _: &Outcome<D::State>) -> Self::Kept {
                collection.0
            }
        }
    )*};
}

lists_of_times! {
    [] Vec<f64>, into;
    [] &Vec<f64>, to_vec;
    [] &[f64], to_vec;
    [const N: usize] [f64; N], into;
    [const N: usize] &[f64; N], into;
}

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
#[derive(Debug)]
pub struct CollectedSteps<S, X>(Vec<At<S, X>>);

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
