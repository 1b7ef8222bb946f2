//! What is collected on the way.

use super::at::At;
use super::dynamics::Dynamics;
use crate::scalar::Scalar;

/// What is told of each sample and each step, in the order of time.
pub trait Collector<S: Scalar, D: Dynamics<S> + ?Sized, T> {
    /// A sample.
    fn sample(&mut self, sample: &At<f64, D::State>) {
        let _ = sample;
    }

    /// An event of that number, and of that index in a declaration, when it occurred, and the state there.
    fn event(&mut self, (event, declared): (usize, Option<usize>), t: S, x: &D::State) {
        let _ = (event, declared, t, x);
    }

    /// The last step of `stepper`, which is part of the motion until `end`.
    fn step(&mut self, dynamics: &D, stepper: &mut T, end: f64) {
        let _ = (dynamics, stepper, end);
    }
}

/// Nothing is collected.
pub struct Uncollected;

impl<S: Scalar, D: Dynamics<S> + ?Sized, T> Collector<S, D, T> for Uncollected {}
