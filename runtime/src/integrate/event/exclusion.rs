//! The exclusion of events from a step by the first terms of the event functions.
//!
//! Most steps are far from any zero. Terms of high order, which are sums of many products, are only computed if the low
//! orders do not decide.

use super::declared_event::DeclaredEvents;
use super::event_dynamics::{EventDynamics, SingleNumber};
use super::terms::{Terms, of_function};
use crate::integrate::bernstein::as_number;
use crate::integrate::step_polynomial::StepPolynomial;
use crate::integrate::taylor::TaylorCoefficients;
use crate::limits::events::{LEADING_HALF_ORDER, MIN_REMAINING_PART};

/// Determines the signs of event functions that have no zero in a step.
pub(super) struct Exclusion<'a, D: ?Sized, X, const K: usize> {
    pub(super) events: &'a DeclaredEvents<K>,
    pub(super) dynamics: &'a D,
    /// The state at the beginning of the step.
    pub(super) from: &'a X,
    /// The time of the end of the step.
    pub(super) end: f64,
    /// The event functions at the end of the step.
    pub(super) last: [f64; K],
}

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
        let [begin, unit_of_time] = [t, unit].map(S::from_f64);
        let series = (self.dynamics).event_series::<LEADING_HALF_ORDER, _>(
            begin,
            self.from,
            unit_of_time,
            motion,
        )?;
        let length = (self.end - t) / unit;
        let accuracy = (S::machine_epsilon(), as_number(1 + 2 * HALF));
        let terms =
            |index: usize| Some(Terms::new(&of_function(&series, index)?, length, accuracy));
        let mut signs = [0.0; K];
        for ((sign, (index, _)), last) in signs.iter_mut().zip(self.events.events).zip(self.last) {
            let of_event = terms(index)?;
            *sign = of_event.sign(MIN_REMAINING_PART)?;
            // If the last terms of a function vanish, a few terms tell nothing about the others.
            let is_cut = of_event.tail() > of_event.rounding();
            if !(is_cut && of_event.is_near(1.0, last) && *sign * last > 0.0) {
                return None;
            }
            for branch in self.dynamics.branches(index) {
                terms(*branch)?.sign(MIN_REMAINING_PART)?;
            }
        }
        Some(signs)
    }
}
