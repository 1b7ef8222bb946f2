//! Models that declare events.

use super::phase::Phase;
use super::quantities::Quantities;
use super::state::State;
use crate::integrate::TaylorCoefficients;
use crate::scalar::Scalar;

/// A model whose declaration has the clause `event(name = expression, …)`.
///
/// An event occurs where its function, the expression, crosses zero. In which direction, and what happens then, is said
/// where the events are watched for ([`Problem::on`](crate::Problem::on)).
#[diagnostic::on_unimplemented(
    message = "`{Self}` declares no events",
    note = "write the clause `event(name = expression)` in its declaration, or give functions to `Problem::when`"
)]
pub trait Events<const N: usize, S: Scalar = f64>: Quantities<N, S> {
    /// The names of the events, in order.
    const EVENTS: &'static [&'static str];

    /// For each event the indices of the values at whose zeros its function has a corner or a jump; empty where no event
    /// has any.
    const BRANCHES: &'static [&'static [usize]] = &[];

    /// One value for each event: an array. With the clause `taylor`, there are more behind them: the arguments whose signs
    /// distinguish the branches of event functions, such as u for |u| and u − v for max(u, v).
    type EventValues: AsRef<[S]> + Copy + core::fmt::Debug;

    /// [`Lagrangian::event_functions`](crate::Lagrangian::event_functions) under these inputs.
    fn event_functions(
        &self,
        state: &State<S, N>,
        inputs: &Self::Inputs,
        prepared: &Self::Prepared,
    ) -> Self::EventValues;

    /// The Taylor coefficients of the event functions along a motion through a state, up to an order that the coefficients of
    /// the motion have, in their unit of time; the motion's coefficient of order 0 is not read. The inputs are
    /// u(t + τ·unit) = Σ uₖ τᵏ, of which `inputs` has the coefficients of order 0, 1, …; those that it does not have are 0.
    /// `None` where they are not known: without the clause `taylor`, or where an event depends on an external function without
    /// series.
    fn event_series<const HALF: usize, const OF_MOTION: usize>(
        &self,
        state: &State<S, N>,
        inputs: &[Self::Inputs],
        prepared: &Self::Prepared,
        unit: S,
        motion: &TaylorCoefficients<Phase<S, N>, OF_MOTION>,
    ) -> Option<TaylorCoefficients<Self::EventValues, HALF>> {
        let _ = (state, inputs, prepared, unit, motion);
        None
    }
}
