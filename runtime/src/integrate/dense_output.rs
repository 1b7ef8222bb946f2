//! Dense output: the motion within a step as a value.

use super::dynamics::Dynamics;
use super::stepper::Advance;
use crate::linalg::VectorSpace;
use crate::scalar::Scalar;

/// The motion within a step: a polynomial in the time.
pub trait Interpolant<S: Scalar, X: VectorSpace<S>>: Clone {
    /// Returns the state at a time.
    fn at(&self, t: f64) -> X;

    /// Returns the derivative of the polynomial at a time. Its error is larger than the error of the state by a factor
    /// of about one over the step size.
    fn derivative(&self, t: f64) -> X;
}

/// A stepper with dense output, whose last step can be kept as a polynomial.
#[diagnostic::on_unimplemented(
    message = "`{Self}` has no dense output",
    note = "fixed steps of `RungeKutta` have none: integrate by `Dop853` or by `Taylor`, or sample at given times"
)]
pub trait DenseOutput<S: Scalar, D: Dynamics<S> + ?Sized>: Advance<S, D> {
    /// The type of the motion within a step.
    type Interpolant: Interpolant<S, D::State>;

    /// Returns the motion within the last step, or `None` before the first. Its value at each time is what
    /// [`interpolate`](Advance::interpolate) returns; it ends at the state to which the step was
    /// [projected](Dynamics::project).
    fn interpolant(&mut self, dynamics: &D) -> Option<Self::Interpolant>;
}
