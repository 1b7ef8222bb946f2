//! Dense output: the motion within a step as a value.

use super::dynamics::Dynamics;
use super::stepper::Advance;
use crate::linalg::VectorSpace;
use crate::scalar::Scalar;

/// The motion within a step: a polynomial in the time.
pub trait Interpolant<S: Scalar, X: VectorSpace<S>>: Clone {
    /// The state at a time.
    fn at(&self, t: f64) -> X;

    /// The derivative of the polynomial at a time. Its error is larger than that of the state by about one over the
    /// step.
    fn derivative(&self, t: f64) -> X;
}

/// A stepper with dense output, whose last step can be kept as a polynomial.
#[diagnostic::on_unimplemented(
    message = "`{Self}` has no dense output",
    note = "fixed steps of `RungeKutta` have none: integrate by `Dop853` or by `Taylor`, or sample at given times"
)]
pub trait DenseOutput<S: Scalar, D: Dynamics<S> + ?Sized>: Advance<S, D> {
    /// The motion within a step.
    type Interpolant: Interpolant<S, D::State>;

    /// The motion within the last step; none before the first. At each time it is what
    /// [`interpolate`](Advance::interpolate) returns; it ends where the step was [projected](Dynamics::project) to.
    fn interpolant(&mut self, dynamics: &D) -> Option<Self::Interpolant>;
}
