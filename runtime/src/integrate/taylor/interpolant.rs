//! The Taylor polynomial of a step, kept.

use super::stepper::difference;
use super::{Series, TaylorCoefficients, TaylorStepper};
use crate::integrate::compensated::{Clock, Compensated};
use crate::integrate::dense_output::{DenseOutput, Interpolant};
use crate::linalg::VectorSpace;
use crate::scalar::Scalar;

/// The motion within a step of a [`Taylor`](crate::Taylor) method: its polynomial, with the error of the step.
#[derive(Clone, Debug, PartialEq)]
pub struct TaylorInterpolant<X, const HALF: usize> {
    clock: Clock,
    from: Compensated<X>,
    unit: f64,
    coefficients: TaylorCoefficients<X, HALF>,
}

impl<X, const HALF: usize> TaylorInterpolant<X, HALF> {
    /// The argument of the polynomial.
    fn argument<S: Scalar>(&self, t: f64) -> S {
        let [high, low] = difference(t, self.clock.time()).map(S::from_f64);
        (high + low) / S::from_f64(self.unit)
    }
}

impl<S: Scalar, X: VectorSpace<S>, const HALF: usize> Interpolant<S, X>
    for TaylorInterpolant<X, HALF>
{
    fn at(&self, t: f64) -> X {
        let change = self.coefficients.change(self.argument::<S>(t));
        self.from.plus(change).into_value()
    }

    fn derivative(&self, t: f64) -> X {
        let rate = S::one() / S::from_f64(self.unit);
        let derivative = self.coefficients.derivative(self.argument::<S>(t));
        derivative.map(|component| component * rate)
    }
}

impl<S, X, D, const HALF: usize> DenseOutput<S, D> for TaylorStepper<X, HALF>
where
    S: Scalar,
    X: VectorSpace<S>,
    D: Series<S, State = X> + ?Sized,
{
    type Interpolant = TaylorInterpolant<X, HALF>;

    fn interpolant(&mut self, _: &D) -> Option<Self::Interpolant> {
        let (clock, from, unit) = self.last.clone()?;
        let coefficients = self.coefficients.clone();
        Some(TaylorInterpolant {
            clock,
            from,
            unit,
            coefficients,
        })
    }
}
