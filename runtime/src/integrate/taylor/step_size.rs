//! The length of a step of the Taylor series method.

use super::TaylorCoefficients;
use super::coefficients::number;
use super::interpolant::TaylorInterpolant;
use crate::integrate::dynamics::Dynamics;
use crate::integrate::tolerance::Tolerance;
use crate::limits::taylor::NEGLIGIBLE_TERM;
use crate::linalg::{ErrorTolerance, VectorSpace};
use crate::scalar::Scalar;

/// The reciprocal tolerances of the components, of the sizes that they reach within a step of this length.
#[inline]
pub(super) fn weights<S, D, const HALF: usize>(
    polynomial: &TaylorInterpolant<D::State, HALF>,
    dynamics: &D,
    tolerance: &ErrorTolerance<S>,
    length: f64,
) -> D::State
where
    S: Scalar,
    D: Dynamics<S> + ?Sized,
{
    let tau = S::from_f64(length / polynomial.unit);
    let mut power = S::one();
    let mut reached = polynomial.from.value().map(Scalar::abs);
    for coefficient in polynomial.coefficients.higher().iter().take(2) {
        power *= tau;
        reached.add_scaled(power, &coefficient.map(Scalar::abs));
    }
    Tolerance::weights(&dynamics.allowed_error(&reached, tolerance))
}

/// The largest component over its tolerance.
#[inline]
pub(super) fn weighted_norm<S: Scalar, X: VectorSpace<S>>(vector: &X, weights: &X) -> f64 {
    let ratios = vector.zip_map(weights, |component, weight| component.abs() * weight);
    let largest = ratios.components().map(Scalar::largest);
    largest.fold(0.0, f64::max)
}

/// What the coefficients of a polynomial say about the length of a step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Proposal {
    /// The step at which the last two terms meet the tolerance, in units (Jorba & Zou 2005, section 3.2). Where they are
    /// zero, as in every other term of an even motion, the terms before count, down to half the order. If those are
    /// zero, too, the motion is a polynomial, as that of a stone, and the step infinite: whether it is one, shows at its
    /// end.
    pub(super) step: f64,
    /// The larger norm of the two terms of about half the order.
    middle: f64,
}

impl Proposal {
    #[inline]
    pub(super) fn of<S: Scalar, X: VectorSpace<S>, const HALF: usize>(
        coefficients: &TaylorCoefficients<X, HALF>,
        weights: &X,
    ) -> Self {
        let mut logarithm = f64::INFINITY;
        for (position, term) in coefficients.higher().iter().rev().enumerate().take(HALF) {
            let norm = weighted_norm(term, weights);
            if norm > 0.0 {
                let order = number(2 * HALF - position);
                logarithm = logarithm.min(-Scalar::ln(norm) / order);
            }
            if position > 0 && logarithm < f64::INFINITY {
                break;
            }
        }
        let middle = coefficients.higher().iter().take(HALF).rev().take(2);
        Self {
            step: Scalar::exp(logarithm),
            middle: middle.fold(0.0, |norm, term| weighted_norm(term, weights).max(norm)),
        }
    }

    /// Whether the terms of half the order hardly count at τ: then the tolerance says little about the length of the
    /// step, and much may happen within it that the series does not see, such as a pulse.
    #[inline]
    pub(super) fn is_of_low_degree(self, tau: f64, half_order: usize) -> bool {
        self.middle * power(tau, half_order) < NEGLIGIBLE_TERM
    }
}

/// A power by repeated squaring.
#[inline]
fn power(x: f64, exponent: usize) -> f64 {
    let (mut product, mut square, mut exponent) = (1.0, x, exponent);
    while exponent > 0 {
        if exponent % 2 == 1 {
            product *= square;
        }
        square *= square;
        exponent /= 2;
    }
    product
}
