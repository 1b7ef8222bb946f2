//! Steps of explicit Runge–Kutta methods that pass singular configurations of constraints.
//!
//! The accelerations are smooth along a motion through such a configuration, but where they are evaluated close to it they
//! have few digits. A step with a stage that is close to one is taken with another length, so that it has the configuration
//! between its stages.

use super::dynamics::Dynamics;
use crate::limits::passing::{CHANGE, CLOSE, CLOSE_PART, MAX_ATTEMPTS, SMALL_SINE};
use crate::scalar::Scalar;

/// Returns the lengths that are tried in place of a fixed step `h`: ever longer ones, since a shorter step may not reach beyond
/// the configuration, and shorter ones where these would not be below `longest`.
pub(crate) fn lengths(h: f64, longest: f64) -> impl Iterator<Item = f64> {
    factors().map(move |factor| {
        let longer = h * factor;
        if longer.abs() < longest.abs() {
            longer
        } else {
            h / factor
        }
    })
}

/// Returns the lengths that are tried in place of a step `h` that has the length which the tolerance allows.
pub(crate) fn shorter_lengths(h: f64) -> impl Iterator<Item = f64> {
    factors().map(move |factor| h / factor)
}

fn factors() -> impl Iterator<Item = f64> {
    (0..MAX_ATTEMPTS).scan(1.0, |next, _| {
        let factor = *next;
        *next *= CHANGE;
        Some(factor)
    })
}

/// How far a step keeps from singular configurations: the smallest and the largest sine between the gradients of constraints at
/// its stages.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Clearance {
    smallest: f64,
    largest: f64,
}

impl Clearance {
    /// A clearance below that of any step, with which a search for the largest begins.
    pub(crate) const NONE: Self = Self {
        smallest: -1.0,
        largest: 0.0,
    };

    /// Before any stage, and where there are no constraints.
    pub(crate) const UNLIMITED: Self = Self {
        smallest: 1.0,
        largest: 0.0,
    };

    /// Returns the clearance of a step with one more stage at this state.
    pub(crate) fn with<S: Scalar, D: Dynamics<S> + ?Sized>(
        self,
        dynamics: &D,
        t: f64,
        x: &D::State,
    ) -> Self {
        let sine = dynamics.constraint_sine(S::from_f64(t), x);
        sine.map_or(self, |sine| Self {
            smallest: self.smallest.min(sine.smallest()),
            largest: self.largest.max(sine.largest()),
        })
    }

    /// Whether no stage is close to a singular configuration.
    pub(crate) fn is_sufficient(self) -> bool {
        self.smallest >= CLOSE.max(CLOSE_PART * self.largest)
    }

    /// Whether this one is larger than another one.
    pub(crate) fn is_larger_than(self, other: Self) -> bool {
        self.smallest > other.smallest
    }

    /// Whether gradients of constraints nearly depend on each other, so that rounding errors exceed small tolerances.
    pub(crate) fn is_small(self) -> bool {
        self.smallest <= SMALL_SINE
    }
}
