//! Access to the polynomial of the last step of a stepper.

use crate::integrate::taylor::coefficients::TaylorCoefficients;
use crate::scalar::Scalar;

/// A visitor of the Taylor polynomial of a step.
pub trait StepPolynomial<S: Scalar, X> {
    /// The result of the visit.
    type Output;

    /// Visits the polynomial, given the time about which it is expanded, the unit of time, and the coefficients. The
    /// coefficient of order 0 may be another state with equal derivatives.
    fn visit<const HALF: usize>(
        self,
        t: f64,
        unit: f64,
        coefficients: &TaylorCoefficients<X, HALF>,
    ) -> Self::Output;
}
