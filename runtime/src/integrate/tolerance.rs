//! The tolerances of adaptive methods.

use super::dynamics::Dynamics;
use super::error::IntegrationError;
use crate::limits::{MAX_TIME_SCALE, USABLE_TIME_SCALE};
use crate::linalg::lane_select::{is_zero, one_if_zero};
use crate::linalg::{ErrorTolerance, LaneStates, VectorSpace};
use crate::scalar::{Lanes, Scalar};

/// The tolerances of the error of a step.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub(crate) struct Tolerance {
    pub(crate) relative: f64,
    pub(crate) absolute: f64,
}

impl Tolerance {
    pub(crate) fn check(self) -> Result<(), IntegrationError> {
        let Self { relative, absolute } = self;
        let valid = |tolerance: f64| tolerance.is_finite() && tolerance >= 0.0;
        if valid(relative) && valid(absolute) && relative + absolute > 0.0 {
            Ok(())
        } else {
            Err(IntegrationError::InvalidTolerance { relative, absolute })
        }
    }

    /// Returns the relative tolerance, or the absolute one if there is no relative one: the tolerance of a component of size 1.
    #[inline]
    pub(crate) fn relative_or_absolute(self) -> f64 {
        if self.relative > 0.0 {
            self.relative
        } else {
            self.absolute
        }
    }

    /// Returns the tolerances of a motion with this time scale, a positive number.
    #[inline]
    pub(crate) fn over<S: Scalar>(self, time_scale: S) -> ErrorTolerance<S> {
        ErrorTolerance {
            relative: self.relative,
            absolute: self.absolute,
            rate: S::one() / time_scale,
        }
    }

    /// Returns the time scale of a motion with this state and derivative: the time in which its coordinates change by
    /// their size. `None` for a state whose unit of time counts as natural; infinite at rest.
    pub(crate) fn time_scale<S: Scalar, D: Dynamics<S> + ?Sized>(
        self,
        dynamics: &D,
        x: &D::State,
        derivative: &D::State,
    ) -> Option<f64> {
        let rates = self.rates(dynamics, x, derivative)?;
        Some(time_scale(rates.map(Scalar::largest)))
    }

    /// Returns the rates at which the coordinates of a motion change by their size: first without moving ignorable
    /// coordinates, whose speed does not matter, then with them.
    pub(crate) fn rates<S: Scalar, D: Dynamics<S> + ?Sized>(
        self,
        dynamics: &D,
        x: &D::State,
        derivative: &D::State,
    ) -> Option<[S; 2]> {
        let largest = S::from_f64(self.relative.max(self.absolute));
        // The size of a moving ignorable coordinate is its displacement over this time.
        let rate_over = |time_scale| {
            let allowed = dynamics.allowed_error(x, &self.over(S::from_f64(time_scale)));
            derivative.rate(&allowed.map(|allowed| allowed / largest))
        };
        Some([rate_over(MAX_TIME_SCALE)?, rate_over(1.0 / MAX_TIME_SCALE)?])
    }

    /// Returns the reciprocals of the allowed errors; 0 where none is allowed.
    #[inline]
    pub(crate) fn weights<S: Scalar, X: VectorSpace<S>>(allowed: &X) -> X {
        let least = allowed.fold(S::from_f64(f64::MAX), Scalar::min);
        if least.smallest() > 0.0 {
            return allowed.map(|allowed| S::one() / allowed);
        }
        allowed.map(|allowed| (S::one() - is_zero(allowed)) / one_if_zero(allowed))
    }
}

/// Returns the time scale for the rates of a motion; infinite at rest.
pub(crate) fn time_scale([rate, with_ignorable]: [f64; 2]) -> f64 {
    let is_rest = |rate: f64| rate * USABLE_TIME_SCALE < 1.0;
    let rate = if is_rest(rate) { with_ignorable } else { rate };
    if rate < USABLE_TIME_SCALE && !is_rest(rate) {
        1.0 / rate
    } else {
        f64::INFINITY
    }
}

/// Returns the ratio of a component to its allowed error, in the worst of its lanes. A component that is zero counts as
/// 0, any other one without an allowed error as `unscaled`.
#[inline]
fn ratio<S: Scalar>(component: S, allowed: S, unscaled: f64) -> f64 {
    let size = component.abs();
    if allowed.smallest() > 0.0 {
        return (size / allowed).largest();
    }
    let without = is_zero(allowed);
    let ratio = (size / one_if_zero(allowed) * (S::one() - without)).largest();
    if (size * without).largest() > 0.0 {
        ratio.max(unscaled)
    } else {
        ratio
    }
}

/// Returns the ratios of all components to their allowed errors.
#[inline]
pub(crate) fn ratios<S: Scalar, X: VectorSpace<S>>(
    vector: &X,
    allowed: &X,
    unscaled: f64,
) -> impl Iterator<Item = f64> {
    let pairs = vector.components().zip(allowed.components());
    pairs.map(move |(component, allowed)| ratio(component, allowed, unscaled))
}

/// Returns the sums of the squares of the ratios of two vectors to the larger of the errors allowed before and after a
/// step, and the number of components.
#[inline]
pub(crate) fn squares_over_step<S: Scalar, X: VectorSpace<S>>(
    [first, second]: [&X; 2],
    [before, after]: &[X; 2],
) -> ([f64; 2], f64) {
    let allowed = before.zip_map(after, Scalar::max);
    let count = allowed.fold(0.0, |count, _| count + 1.0);
    // Weights are infinite if no error, or almost none, is allowed, and then so are the sums.
    let weights = allowed.map(|allowed| S::one() / allowed);
    let squares = |vector: &X| {
        let ratios = vector.zip_map(&weights, |component, weight| component * weight);
        ratios.fold(0.0, |sum, ratio| sum + (ratio * ratio).largest())
    };
    let sums = [squares(first), squares(second)];
    if (sums[0] + sums[1]).is_finite() {
        return (sums, count);
    }
    let squares = |vector: &X| squares_one_by_one(vector, &allowed);
    ([squares(first), squares(second)], count)
}

/// Returns the sum of the squares if some component has no allowed error.
#[cold]
fn squares_one_by_one<S: Scalar, X: VectorSpace<S>>(vector: &X, allowed: &X) -> f64 {
    let ratios = ratios(vector, allowed, f64::INFINITY);
    ratios.fold(0.0, |sum, ratio| sum + ratio * ratio)
}

/// Returns the largest ratio of a component to its tolerance in each lane, given the reciprocals of the tolerances. The
/// result is NaN if a component is not finite; components without a tolerance do not count.
#[inline]
pub(crate) fn largest_ratios<X: LaneStates<L>, const L: usize>(
    vector: &X,
    weights: &X,
) -> Lanes<L> {
    let zero = Lanes::from_f64(0.0);
    let ratios = vector.zip_map(weights, |component, weight| component.abs() * weight);
    // Adds 0, or NaN if the component is not finite.
    let finite = vector.fold(zero, |sum, component| component.mul_add(zero, sum));
    ratios.fold(zero, |most, ratio| ratio.larger(most)) + finite
}
