//! The correction of the end of a step by the derivative of the motion there.
//!
//! The derivative with which a polynomial of degree n is compared at its end also contains the first term that it omits.
//! Obreshkov's formula for the first n derivatives at the beginning of a step and one at its end evaluates the polynomial of degree
//! n + 1 that has them (E. Hairer, S. P. Nørsett & G. Wanner, *Solving Ordinary Differential Equations I*, 2nd edition (1993), II.13).
//! With the derivative at the end of the Taylor polynomial it is explicit and has the order n + 1; for linear equations with
//! constant coefficients it is the Taylor polynomial of this degree. In general its error is
//! (xₙ₊₂hⁿ⁺² − h ∂f/∂x · xₙ₊₁hⁿ⁺¹)/(n + 1) up to higher orders.

use super::Taylor;
use super::coefficients::number;
use crate::limits::taylor::MIN_CORRECTED;
use crate::linalg::VectorSpace;
use crate::scalar::Scalar;

impl<const HALF: usize> Taylor<HALF> {
    /// Whether the ends of steps are corrected.
    pub(super) fn corrects<S: Scalar>(&self) -> bool {
        let tolerance = self.tolerance::<S>();
        let largest = tolerance.relative.max(tolerance.absolute);
        largest >= MIN_CORRECTED * S::machine_epsilon() && !self.passes_singularities
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
