//! What a stepper shows of its last step: the polynomial, where it has one.

use crate::integrate::taylor::coefficients::TaylorCoefficients;
use crate::scalar::Scalar;

/// What is done with the Taylor polynomial of a step.
pub trait StepPolynomial<S: Scalar, X> {
    /// What comes out.
    type Output;

    /// Called with the time about which the polynomial is, the unit of time, and the coefficients, of which that of order
    /// 0 may be another state with the same derivatives.
    fn visit<const HALF: usize>(
        self,
        t: f64,
        unit: f64,
        coefficients: &TaylorCoefficients<X, HALF>,
    ) -> Self::Output;
}
