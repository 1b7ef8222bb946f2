//! Models that declare events.

use super::equations_of_motion::EquationsOfMotion;
use super::lagrangian::Lagrangian;
use super::owned_equations::OwnedEquations;
use super::phase::Phase;
use super::state::State;
use crate::integrate::{EventDynamics, TaylorCoefficients};
use crate::scalar::Scalar;

/// A model whose declaration has the clause `event(name = expression, …)`.
///
/// An event occurs where its function, the expression, crosses zero. In which direction, and what happens then, is said
/// where the events are watched for ([`Driver::declared_events`](crate::Driver::declared_events)).
#[diagnostic::on_unimplemented(
    message = "`{Self}` declares no events",
    note = "write the clause `event(name = expression)` in its declaration, or give functions to `Driver::events`"
)]
pub trait Events<const N: usize, S: Scalar = f64>: Lagrangian<N, S> {
    /// The names of the events, in order.
    const EVENTS: &'static [&'static str];

    /// One value for each event: an array.
    type EventValues: AsRef<[S]> + Copy + core::fmt::Debug;

    /// The values of the event functions. Inputs have the values of their fields.
    fn event_functions(&self, state: &State<S, N>) -> Self::EventValues;

    /// The Taylor coefficients of the event functions along a motion through a state, given those of the motion, in their
    /// unit of time; its coefficients of order 0 are not read. `None` where they are not known: without the clause
    /// `taylor`, or where an event depends on an external function without series.
    fn event_series<const HALF: usize>(
        &self,
        state: &State<S, N>,
        unit: S,
        motion: &TaylorCoefficients<Phase<S, N>, HALF>,
    ) -> Option<TaylorCoefficients<Self::EventValues, HALF>> {
        let _ = (state, unit, motion);
        None
    }
}

/// The methods that both kinds of equations of motion have.
macro_rules! event_dynamics {
    () => {
        type Values = M::EventValues;

        fn names(&self) -> &'static [&'static str] {
            M::EVENTS
        }

        #[inline]
        fn event_functions(&self, t: S, x: &Phase<S, N>) -> M::EventValues {
            self.model.event_functions(&x.at(t))
        }

        #[inline]
        fn event_series<const HALF: usize>(
            &self,
            t: S,
            x: &Phase<S, N>,
            unit: S,
            motion: &TaylorCoefficients<Phase<S, N>, HALF>,
        ) -> Option<TaylorCoefficients<M::EventValues, HALF>> {
            self.model.event_series(&x.at(t), unit, motion)
        }
    };
}

impl<M, S, const N: usize> EventDynamics<S> for EquationsOfMotion<'_, M, S, N>
where
    M: Events<N, S> + ?Sized,
    S: Scalar,
{
    event_dynamics!();
}

impl<M, S, const N: usize> EventDynamics<S> for OwnedEquations<M, S, N>
where
    M: Events<N, S>,
    S: Scalar,
{
    event_dynamics!();
}
