//! The Taylor polynomial of a motion about a time.

use super::TaylorCoefficients;
use crate::integrate::compensated::Compensated;
use crate::integrate::dense_output::Interpolant;
use crate::linalg::VectorSpace;
use crate::scalar::Scalar;

/// The motion within a step of a [`Taylor`](crate::Taylor) method: the polynomial of the step, with the error of the
/// step.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(
    feature = "serde",
    serde(bound(
        serialize = "X: serde::Serialize",
        deserialize = "X: Clone + serde::Deserialize<'de>"
    ))
)]
pub struct TaylorInterpolant<X, const HALF: usize> {
    /// The time about which the polynomial is expanded.
    pub(super) time: f64,
    /// The state at that time.
    pub(super) from: Compensated<X>,
    /// The unit of time of the coefficients.
    pub(super) unit: f64,
    /// The coefficients about the reduced state.
    pub(super) coefficients: TaylorCoefficients<X, HALF>,
}

impl<X, const HALF: usize> TaylorInterpolant<X, HALF> {
    /// Creates the polynomial that is constant at `x`, until its coefficients are computed.
    pub(super) fn at_rest<S: Scalar>(time: f64, x: X) -> Self
    where
        X: VectorSpace<S>,
    {
        Self {
            time,
            unit: 1.0,
            coefficients: TaylorCoefficients::new(x.zeroed()),
            from: Compensated::new(x),
        }
    }

    /// Returns the argument of the polynomial at a time.
    pub(super) fn argument<S: Scalar>(&self, t: f64) -> S {
        let [high, low] = difference(t, self.time).map(S::from_f64);
        (high + low) / S::from_f64(self.unit)
    }

    /// Returns the state at an argument, and its derivative with respect to time.
    #[inline]
    pub(super) fn state_and_derivative<S: Scalar>(&self, tau: S) -> (Compensated<X>, X)
    where
        X: VectorSpace<S>,
    {
        let (change, derivative) = self.coefficients.change_and_derivative(tau);
        let rate = S::one() / S::from_f64(self.unit);
        let derivative = derivative.map(|component| component * rate);
        (self.from.plus(change), derivative)
    }

    /// Returns the derivative at the time about which the polynomial is expanded.
    #[inline]
    pub(super) fn first_derivative<S: Scalar>(&self) -> X
    where
        X: VectorSpace<S>,
    {
        let rate = S::one() / S::from_f64(self.unit);
        let first = self.coefficients.higher().first();
        let first = first.unwrap_or(self.coefficients.initial());
        first.map(|component| component * rate)
    }
}

impl<S: Scalar, X: VectorSpace<S>, const HALF: usize> Interpolant<S, X>
    for TaylorInterpolant<X, HALF>
{
    fn at(&self, t: f64) -> X {
        let change = self.coefficients.change(self.argument::<S>(t));
        self.from.plus(change).into_value()
    }

    fn derivative(&self, t: f64) -> X {
        self.state_and_derivative(self.argument::<S>(t)).1
    }
}

/// Returns the exact difference of two numbers as a sum of two numbers (Knuth, *The Art of Computer Programming* **2**,
/// 3rd edition (1997), section 4.2.2, theorem B).
#[inline]
pub(super) fn difference<S: Scalar>(x: S, y: S) -> [S; 2] {
    let high = x - y;
    let part = high - x;
    [high, (x - (high - part)) - (y + part)]
}
