//! The correction of the end of a step.

use super::TaylorStepper;
use crate::integrate::taylor::correction::correction;
use crate::integrate::taylor::residual::Point;
use crate::linalg::VectorSpace;
use crate::scalar::Scalar;

impl<X, const HALF: usize> TaylorStepper<X, HALF> {
    /// Corrects the end of a step, where the other polynomial begins, by the derivative of the motion there, and changes the
    /// polynomial of the step to end there. `point` is the end before the correction, at this argument of the polynomial.
    pub(super) fn correct_end<S: Scalar>(&mut self, point: &Point<S, X>, derivative: &X, tau: S)
    where
        X: VectorSpace<S>,
    {
        let [present, next] = [self.exchanged, !self.exchanged].map(usize::from);
        let h = self.polynomials[next].time - self.polynomials[present].time;
        let slopes = [&point.slope, derivative];
        let change = correction(S::from_f64(h), slopes, 2 * HALF);
        self.polynomials[present]
            .coefficients
            .change_end(tau, &change);
        self.polynomials[next].from = self.polynomials[next].from.plus(change);
    }
}
