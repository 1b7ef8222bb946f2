//! The exclusion of events from a step by the first terms of the event functions.
//!
//! Most steps are far from any zero. Terms of high order, which are sums of many products, are only computed if the low
//! orders do not decide.

use super::event_dynamics::{EventDynamics, SingleNumber};
use super::functions_in_step::FunctionsInStep;
use super::terms::Terms;
use crate::integrate::step_polynomial::StepPolynomial;
use crate::integrate::taylor::TaylorCoefficients;
use crate::limits::events::{LEADING_HALF_ORDER, MIN_REMAINING_PART};

/// Determines the signs of event functions that have no zero in a step.
pub(super) struct Exclusion<'a, D: ?Sized, X, const K: usize>(
    pub(super) FunctionsInStep<'a, D, X, K>,
);

impl<S, D, const K: usize> StepPolynomial<S, D::State> for Exclusion<'_, D, D::State, K>
where
    S: SingleNumber,
    D: EventDynamics<S> + ?Sized,
{
    /// The signs. `None` if the first terms do not exclude zeros of one of the functions, or of the functions at whose zeros it
    /// has corners, or if a function differs from its polynomial.
    type Output = Option<[f64; K]>;

    fn visit<const HALF: usize>(
        self,
        t: f64,
        unit: f64,
        motion: &TaylorCoefficients<D::State, HALF>,
    ) -> Self::Output {
        if HALF <= LEADING_HALF_ORDER {
            return None;
        }
        let sign = |terms: &Terms<f64, LEADING_HALF_ORDER>, last: f64| {
            let sign = terms.sign(MIN_REMAINING_PART)?;
            // If the last terms of a function vanish, a few terms tell nothing about the others.
            let is_cut = terms.tail() > terms.rounding();
            (is_cut && terms.ends_near(last) && sign * last > 0.0).then_some(sign)
        };
        self.0.examined((t, unit), motion, MIN_REMAINING_PART, sign)
    }
}
