//! Collectors of samples, events and steps.

use super::at::At;
use super::dynamics::Dynamics;
use crate::scalar::Scalar;

/// Receives each sample, event and step, in the order of time.
pub trait Collector<S: Scalar, D: Dynamics<S> + ?Sized, T> {
    /// Receives a sample.
    fn sample(&mut self, sample: &At<f64, D::State>) {
        let _ = sample;
    }

    /// Receives an event: its number, its index in a declaration if it has one, the time of its occurrence, and the
    /// state there.
    fn event(&mut self, (event, declared): (usize, Option<usize>), t: S, x: &D::State) {
        let _ = (event, declared, t, x);
    }

    /// Receives the last step of `stepper`, which is part of the motion until `end`.
    fn step(&mut self, dynamics: &D, stepper: &mut T, end: f64) {
        let _ = (dynamics, stepper, end);
    }
}

/// A collector that discards everything.
pub struct Uncollected;

impl<S: Scalar, D: Dynamics<S> + ?Sized, T> Collector<S, D, T> for Uncollected {}
