//! What a driver collects on the way.

use super::dynamics::Dynamics;
use super::sample::Sample;
use crate::scalar::Scalar;

/// What is told of each sample and each step, in the order of time.
pub(crate) trait Collector<S: Scalar, D: Dynamics<S> + ?Sized, T> {
    /// A sample.
    fn sample(&mut self, sample: &Sample<D::State>) {
        let _ = sample;
    }

    /// The last step of `stepper`, which is part of the motion until `end`.
    fn step(&mut self, dynamics: &D, stepper: &mut T, end: f64) {
        let _ = (dynamics, stepper, end);
    }
}

/// Nothing is collected.
pub(crate) struct Uncollected;

impl<S: Scalar, D: Dynamics<S> + ?Sized, T> Collector<S, D, T> for Uncollected {}

/// The samples.
#[cfg(feature = "alloc")]
pub(crate) struct Samples<X>(pub(crate) alloc::vec::Vec<Sample<X>>);

#[cfg(feature = "alloc")]
impl<S: Scalar, D: Dynamics<S> + ?Sized, T> Collector<S, D, T> for Samples<D::State> {
    fn sample(&mut self, sample: &Sample<D::State>) {
        self.0.push(sample.clone());
    }
}
