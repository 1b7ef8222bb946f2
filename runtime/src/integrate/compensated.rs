//! Sums that keep what rounding takes away.

use crate::linalg::VectorSpace;
use crate::scalar::Scalar;

/// A value and the part of it that was lost in rounding: Kahan's compensated summation.
///
/// After n steps the rounding error of a plain sum has grown like n (like √n at best), that of a
/// compensated sum not at all. See Hairer, Lubich & Wanner, *Geometric Numerical Integration*,
/// VIII.5.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Compensated<X> {
    value: X,
    carry: X,
}

impl<X> Compensated<X> {
    pub(crate) fn new<S: Scalar>(value: X) -> Self
    where
        X: VectorSpace<S>,
    {
        let carry = value.zeroed();
        Self { value, carry }
    }

    pub(crate) fn value(&self) -> &X {
        &self.value
    }

    /// This value plus `increment`; what rounding takes from the sum is carried to the next.
    #[inline]
    pub(crate) fn plus<S: Scalar>(&self, mut increment: X) -> Self
    where
        X: VectorSpace<S>,
    {
        increment.add_scaled(S::one(), &self.carry);
        let mut value = self.value.clone();
        value.add_scaled(S::one(), &increment);
        let mut gained = value.clone();
        gained.add_scaled(-S::one(), &self.value);
        increment.add_scaled(-S::one(), &gained);
        Self {
            value,
            carry: increment,
        }
    }
}

/// The time of a stepper, with its carry.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Clock {
    time: f64,
    carry: f64,
}

impl Clock {
    pub(crate) fn new(time: f64) -> Self {
        Self { time, carry: 0.0 }
    }

    pub(crate) fn time(&self) -> f64 {
        self.time
    }

    /// The time from now to `target`.
    pub(crate) fn until(&self, target: f64) -> f64 {
        (target - self.time) - self.carry
    }

    /// The time at a duration from now.
    pub(crate) fn after(&self, duration: f64) -> f64 {
        self.time + (duration + self.carry)
    }

    pub(crate) fn advance(&mut self, step: f64) {
        let increment = step + self.carry;
        let time = self.time + increment;
        self.carry = increment - (time - self.time);
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
