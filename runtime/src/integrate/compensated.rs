//! Compensated summation of times and states.
//!
//! W. Kahan, *Further Remarks on Reducing Truncation Errors*, Comm. ACM **8** (1965) 40. For integrators: Hairer,
//! Lubich & Wanner, *Geometric Numerical Integration*, 2nd edition (2006), VIII.5.

use super::dynamics::Dynamics;
use crate::linalg::{LaneStates, VectorSpace};
use crate::scalar::Scalar;

/// A state and its compensation: what rounding has removed from it.
///
/// After n steps the rounding error of a plain sum has grown in proportion to n (√n at best); the error of a
/// compensated sum does not grow.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(target_feature = "avx", repr(align(64)))] // Lanes are loaded from whole cache lines.
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub(crate) struct Compensated<X> {
    value: X,
    compensation: X,
}

impl<X> Compensated<X> {
    pub(crate) fn new<S: Scalar>(value: X) -> Self
    where
        X: VectorSpace<S>,
    {
        let compensation = value.zeroed();
        Self {
            value,
            compensation,
        }
    }

    pub(crate) fn value(&self) -> &X {
        &self.value
    }

    pub(crate) fn into_value(self) -> X {
        self.value
    }

    /// Returns the state at which the derivatives of a step from this state are evaluated.
    #[inline]
    pub(crate) fn reduced<S: Scalar, D: Dynamics<S, State = X> + ?Sized>(&self, dynamics: &D) -> X
    where
        X: VectorSpace<S>,
    {
        dynamics.reduced(&self.value, &self.compensation)
    }

    /// Returns this state plus `increment`; the rounding error of the sum becomes the compensation.
    #[inline]
    pub(crate) fn plus<S: Scalar>(&self, mut increment: X) -> Self
    where
        X: VectorSpace<S>,
    {
        increment.add_scaled(S::one(), &self.compensation);
        let mut value = self.value.clone();
        value.add_scaled(S::one(), &increment);
        let mut gained = value.clone();
        gained.add_scaled(-S::one(), &self.value);
        increment.add_scaled(-S::one(), &gained);
        Self {
            value,
            compensation: increment,
        }
    }
}

impl<X> Compensated<X> {
    /// Returns the state in a lane.
    pub(crate) fn lane<const L: usize>(&self, lane: usize) -> Compensated<X::Lane>
    where
        X: LaneStates<L>,
    {
        Compensated {
            value: self.value.lane(lane),
            compensation: self.compensation.lane(lane),
        }
    }

    /// Returns the state of a lane in every lane.
    pub(crate) fn in_every_lane<const L: usize>(&self, lane: usize) -> Self
    where
        X: LaneStates<L>,
    {
        let every = |x: &X| X::broadcast(&x.lane(lane));
        Self {
            value: every(&self.value),
            compensation: every(&self.compensation),
        }
    }

    /// Sets the state in a lane, with a compensation of zero.
    pub(crate) fn set_lane<const L: usize>(&mut self, lane: usize, state: &X::Lane)
    where
        X: LaneStates<L>,
    {
        self.value.set_lane(lane, state);
        self.compensation.set_lane(lane, &state.zeroed());
    }

    /// Copies a lane, with its compensation, from `other`.
    pub(crate) fn copy_lane<const L: usize>(&mut self, lane: usize, other: &Self)
    where
        X: LaneStates<L>,
    {
        self.value.set_lane(lane, &other.value.lane(lane));
        let compensation = other.compensation.lane(lane);
        self.compensation.set_lane(lane, &compensation);
    }
}

/// The time of a stepper, as a compensated sum.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub(crate) struct Clock {
    time: f64,
    compensation: f64,
}

impl Clock {
    pub(crate) fn new(time: f64) -> Self {
        Self {
            time,
            compensation: 0.0,
        }
    }

    pub(crate) fn time(&self) -> f64 {
        self.time
    }

    /// Returns the duration from now to `target`.
    pub(crate) fn until(&self, target: f64) -> f64 {
        (target - self.time) - self.compensation
    }

    /// Returns the time at a duration from now.
    pub(crate) fn after(&self, duration: f64) -> f64 {
        self.time + (duration + self.compensation)
    }

    pub(crate) fn advance(&mut self, step: f64) {
        let increment = step + self.compensation;
        let time = self.time + increment;
        self.compensation = increment - (time - self.time);
        self.time = time;
    }
}

#[cfg(test)]
mod tests {
    use nalgebra::SVector;

    use super::{Clock, Compensated};

    #[test]
    fn a_million_tenths_are_a_hundred_thousand() {
        let mut plain: f64 = 0.0;
        let mut clock = Clock::new(0.0);
        let mut state = Compensated::new(SVector::from([0.0_f64]));
        for _ in 0..1_000_000 {
            plain += 0.1;
            clock.advance(0.1);
            state = state.plus(SVector::from([0.1]));
        }
        // 0.1 itself is off by 5.6e-18, a million of them by 5.6e-12; an ulp of 1e5 is 1.5e-11.
        assert!((clock.time() - 1e5).abs() <= 1.5e-11);
        assert!((state.value()[0] - 1e5).abs() <= 1.5e-11);
        assert!((plain - 1e5).abs() > 1e-7, "the plain sum is not that good");
    }
}
