//! Dense output: the state between the ends of a step.

use super::{ALL_STAGES, STAGES, coefficients::DENSE};
use crate::integrate::compensated::Clock;
use crate::integrate::dense_output::Interpolant;
use crate::integrate::runge_kutta::combination;
use crate::linalg::VectorSpace;
use crate::scalar::Scalar;

/// The interpolating polynomial of order 7: Hairer, Nørsett & Wanner, *Solving Ordinary Differential Equations I*, 2nd
/// edition (1993), II.6, (6.11) and below.
///
/// In θ = (t − t₀)/h it is r₀ + θ (r₁ + (1 − θ) (r₂ + θ (r₃ + (1 − θ) (r₄ + …)))).
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub(super) struct DensePolynomial<X> {
    start: X,
    coefficients: [X; 7],
}

impl<X> DensePolynomial<X> {
    /// Returns the polynomial from `start` to `end` over a step `h`, with the derivatives of all stages.
    pub(super) fn new<S: Scalar>(start: &X, end: &X, h: f64, stages: &[X; ALL_STAGES]) -> Self
    where
        X: VectorSpace<S>,
    {
        let length = S::from_f64(h);
        let scaled = |slope: &X| slope.map(|slope| slope * length);
        let minus = |mut a: X, b: &X| {
            a.add_scaled(-S::one(), b);
            a
        };
        let zero = start.zeroed();
        let difference = minus(end.clone(), start);
        let at_start = minus(scaled(&stages[0]), &difference);
        let at_end = minus(
            minus(difference.clone(), &scaled(&stages[STAGES])),
            &at_start,
        );
        let [a, b, c, d] = DENSE.map(|row| scaled(&combination(&row, stages, &zero)));
        Self {
            start: start.clone(),
            coefficients: [difference, at_start, at_end, a, b, c, d],
        }
    }

    /// Returns the state at the fraction θ of the step.
    pub(super) fn at<S: Scalar>(&self, fraction: f64) -> X
    where
        X: VectorSpace<S>,
    {
        let theta = S::from_f64(fraction);
        let rest = S::from_f64(1.0 - fraction);
        let mut value = self.start.zeroed();
        // The innermost of the seven factors is θ; outwards, 1 − θ and θ alternate.
        for (i, coefficient) in self.coefficients.iter().enumerate().rev() {
            value.add_scaled(S::one(), coefficient);
            let factor = if i % 2 == 0 { theta } else { rest };
            value = value.map(|component| component * factor);
        }
        value.add_scaled(S::one(), &self.start);
        value
    }
    /// Returns the derivative with respect to θ.
    fn derivative<S: Scalar>(&self, fraction: f64) -> X
    where
        X: VectorSpace<S>,
    {
        let theta = S::from_f64(fraction);
        let rest = S::from_f64(1.0 - fraction);
        let mut value = self.start.zeroed();
        let mut slope = value.clone();
        for (i, coefficient) in self.coefficients.iter().enumerate().rev() {
            value.add_scaled(S::one(), coefficient);
            let (factor, sign) = if i % 2 == 0 {
                (theta, S::one())
            } else {
                (rest, -S::one())
            };
            slope = slope.map(|component| component * factor);
            slope.add_scaled(sign, &value);
            value = value.map(|component| component * factor);
        }
        slope
    }
}

/// The motion within a step of [`Dop853`](crate::Dop853), with an error of order 8 in the step.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Dop853Interpolant<X> {
    pub(super) clock: Clock,
    pub(super) h: f64,
    pub(super) polynomial: DensePolynomial<X>,
}

impl<S: Scalar, X: VectorSpace<S>> Interpolant<S, X> for Dop853Interpolant<X> {
    fn at(&self, t: f64) -> X {
        self.polynomial.at(self.clock.until(t) / self.h)
    }

    fn derivative(&self, t: f64) -> X {
        let rate = S::one() / S::from_f64(self.h);
        let slope = self.polynomial.derivative(self.clock.until(t) / self.h);
        slope.map(|component| component * rate)
    }
}
