//! The error of the derivative parts of a step of dual numbers.
//!
//! The derivative parts with one index form a vector that moves with the linearized motion. Its error is measured
//! relative to its size, both in units of the errors that are allowed for the values. So derivatives are equally
//! accurate where the values are at rest, and whatever their units are.

use super::ALL_STAGES;
use super::coefficients::{FIFTH_ORDER_ERROR, THIRD_ORDER, WEIGHTS};
use crate::integrate::runge_kutta::combination;
use crate::integrate::tolerance::Tolerance;
use crate::limits::dormand_prince::THIRD_ORDER_WEIGHT;
use crate::linalg::VectorSpace;
use crate::scalar::Scalar;

/// An attempted step of size `h`: its stages, and the states and the allowed errors at its ends.
pub(super) struct Attempted<'a, X> {
    pub(super) stages: &'a [X; ALL_STAGES],
    pub(super) h: f64,
    pub(super) ends: [&'a X; 2],
    pub(super) allowed: &'a [X; 2],
    pub(super) tolerance: Tolerance,
}

impl<X> Attempted<'_, X> {
    /// Returns the largest of the error `of_values` and the errors of the derivative parts by the same formula, over
    /// the tolerance.
    #[inline]
    pub(super) fn error<S: Scalar>(&self, of_values: f64) -> f64
    where
        X: VectorSpace<S>,
    {
        if S::DERIVATIVES == 0 {
            return of_values;
        }
        let zero = self.allowed[0].zeroed();
        let fifth = combination(&FIFTH_ORDER_ERROR, self.stages, &zero);
        let mut third = combination(&WEIGHTS, self.stages, &zero);
        third.add_scaled(-S::one(), &combination(&THIRD_ORDER, self.stages, &zero));
        (0..S::DERIVATIVES).fold(of_values, |error, part| {
            let of_part = self.of_part(&fifth, &third, part);
            if of_part > error || of_part.is_nan() {
                of_part
            } else {
                error
            }
        })
    }

    fn of_part<S: Scalar>(&self, fifth: &X, third: &X, part: usize) -> f64
    where
        X: VectorSpace<S>,
    {
        let largest = |vector: &X| self.sizes(vector, part).fold(0.0, f64::max);
        let moved = self.h.abs() * largest(&self.stages[0]);
        let [before, after] = self.ends.map(largest);
        let size = self.tolerance.over(1.0).of_derivatives() * moved.max(before).max(after);
        let squares = |vector: &X| {
            let ratios = self.sizes(vector, part).map(|part| part / size);
            ratios.fold(0.0, |sum, ratio| sum + ratio * ratio)
        };
        let components = fifth.components().fold(0.0, |count, _| count + 1.0);
        let (fifth, third) = (squares(fifth), squares(third));
        let denominator = fifth + THIRD_ORDER_WEIGHT * third;
        if size <= 0.0 || denominator <= 0.0 {
            return 0.0;
        }
        self.h.abs() * fifth / Scalar::sqrt(components * denominator)
    }

    /// Returns the derivative parts of an index, in units of the sizes of the components.
    fn sizes<S: Scalar>(&self, vector: &X, part: usize) -> impl Iterator<Item = f64>
    where
        X: VectorSpace<S>,
    {
        let [before, after] = self.allowed;
        let allowed = before.components().zip(after.components());
        let relative = self.tolerance.over(1.0).of_derivatives();
        vector
            .components()
            .zip(allowed)
            .map(move |(component, (before, after))| {
                let derivative = component.derivative_part(part).abs();
                match before.largest().max(after.largest()) {
                    allowed if allowed > 0.0 => derivative / allowed * relative,
                    // A component that is zero and has no absolute tolerance is of size 1.
                    _ => derivative,
                }
            })
    }
}
