//! Taylor polynomials of solutions from the coefficients of the right-hand side.

use super::terms::number;
use crate::integrate::taylor::TaylorCoefficients;
use crate::linalg::VectorSpace;
use crate::scalar::Scalar;

/// The order k of the coefficients that a recurrence computes, with the coefficients of the time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Order<S> {
    order: usize,
    time: S,
}

impl<S: Scalar> Order<S> {
    /// Returns k.
    #[must_use]
    pub fn get(&self) -> usize {
        self.order
    }

    /// Returns the coefficient of order k of the time: t for k = 0, the unit of time for k = 1, otherwise 0.
    #[must_use]
    pub fn time(&self) -> S {
        self.time
    }

    /// Returns the coefficient of order k of a constant: its value for k = 0, otherwise 0.
    #[must_use]
    pub fn constant(&self, value: S) -> S {
        if self.order == 0 { value } else { S::zero() }
    }
}

impl<X, const HALF: usize> TaylorCoefficients<X, HALF> {
    /// Sets the polynomial of the solution of ẋ = f(t, x) through (t, x), in this unit of time, by
    /// xₖ₊₁ = fₖ·unit/(k + 1).
    ///
    /// `derivative` is called with the orders 0, 1, … in turn and the coefficient of the state of that order. It
    /// returns the coefficient of f, for which [`recurrences`](crate::recurrences) has the building blocks.
    pub fn solve<S: Scalar>(
        &mut self,
        t: S,
        x: &X,
        unit: S,
        mut derivative: impl FnMut(Order<S>, &X) -> X,
    ) where
        X: VectorSpace<S>,
    {
        let mut last = x.clone();
        for (order, coefficient) in self.higher_mut().iter_mut().enumerate() {
            let time = match order {
                0 => t,
                1 => unit,
                _ => S::zero(),
            };
            let step = unit / number(order + 1);
            let slope = derivative(Order { order, time }, &last);
            last = slope.map(|component| component * step);
            coefficient.clone_from(&last);
        }
        self.initial_mut().clone_from(x);
    }
}
