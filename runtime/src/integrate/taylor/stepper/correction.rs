//! The correction of the end of a step.

use super::TaylorStepper;
use crate::integrate::taylor::coefficients::{divides, power};
use crate::integrate::taylor::correction::correction;
use crate::integrate::taylor::residual::Point;
use crate::linalg::VectorSpace;
use crate::scalar::Scalar;

impl<X, const HALF: usize> TaylorStepper<X, HALF> {
    /// Corrects the end of a step, where the other polynomial begins, by the derivative of the motion there, and changes the
    /// polynomial of the step to end there. `point` is the end before the correction, at this argument of the polynomial.
    ///
    /// A step that is so short that the correction does not fit into the last coefficient is left as it is.
    pub(super) fn correct_end<S: Scalar>(&mut self, point: &Point<S, X>, derivative: &X, tau: S)
    where
        X: VectorSpace<S>,
    {
        let highest = power(tau, 2 * HALF);
        if !divides(highest) {
            return;
        }
        let [present, next] = [self.exchanged, !self.exchanged].map(usize::from);
        let h = self.polynomials[next].time - self.polynomials[present].time;
        let slopes = [&point.slope, derivative];
        let change = correction(S::from_f64(h), slopes, 2 * HALF);
        let coefficients = &mut self.polynomials[present].coefficients;
        if let Some(last) = coefficients.higher_mut().last_mut() {
            last.add_scaled(S::one() / highest, &change);
        }
        self.polynomials[next].from = self.polynomials[next].from.plus(change);
    }
}
