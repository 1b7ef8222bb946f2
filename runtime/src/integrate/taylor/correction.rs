//! The correction of the end of a step by the derivative of the motion there.
//!
//! The derivative with which a polynomial of degree n is compared at its end also contains the first term that it omits.
//! Obreschkoff's formula for the first n derivatives at the beginning of a step and one at its end evaluates the polynomial of degree
//! n + 1 that has them (E. Hairer, S. P. Nørsett & G. Wanner, *Solving Ordinary Differential Equations I*, 2nd edition (1993), II.13).
//! With the Taylor polynomial as predictor, and this formula as corrector, which is evaluated once, the order is n + 1; for linear
//! equations with constant coefficients, the end is the value of the Taylor polynomial of this degree. In general the local error is
//! (xₙ₊₂hⁿ⁺² − h ∂f/∂x · xₙ₊₁hⁿ⁺¹)/(n + 1) up to higher orders.
//!
//! Equations with branches are not corrected: a correction could move an end across a discontinuity surface, where no step would
//! arrive.

use super::Taylor;
use super::coefficients::number;
use crate::limits::taylor::MIN_CORRECTED;
use crate::linalg::VectorSpace;
use crate::scalar::Scalar;

impl<const HALF: usize> Taylor<HALF> {
    /// Whether the ends of steps are corrected, unless the equations have branches.
    pub(super) fn corrects<S: Scalar>(&self) -> bool {
        let part = self.tolerance::<S>().relative_or_absolute();
        part >= MIN_CORRECTED * S::machine_epsilon() && !self.passes_singularities
    }
}

/// Returns the change of the end of a step of the signed length `h`, given the derivatives there of its polynomial, which is of
/// this order, and of the motion.
#[inline]
pub(super) fn correction<S: Scalar, X: VectorSpace<S>>(
    h: S,
    [polynomial, motion]: [&X; 2],
    order: usize,
) -> X {
    let part = h / S::from_f64(number(order + 1));
    polynomial.zip_map(motion, |polynomial, motion| (motion - polynomial) * part)
}
