//! Models that declare events.

use nalgebra::SVector;

use super::augmented_phase::AugmentedPhase;
use super::controlled_by::ControlledBy;
use super::driven_by::DrivenBy;
use super::equations_of_motion::EquationsOfMotion;
use super::inputs::Inputs;
use super::owned_equations::OwnedEquations;
use super::phase::Phase;
use super::quantities::Quantities;
use super::signals::Signals;
use super::state::State;
use super::with_controller::WithController;
use crate::integrate::{EventDynamics, TaylorCoefficients};
use crate::linalg::IntoVector;
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

    /// The Taylor coefficients of the event functions along a motion through a state, given those of the motion, in their
    /// unit of time; its coefficients of order 0 are not read. The inputs are u(t + τ·unit) = Σ uₖ τᵏ, of which `inputs` has
    /// the coefficients of order 0, 1, …; those that it does not have are 0. `None` where they are not known: without the clause
    /// `taylor`, or where an event depends on an external function without series.
    fn event_series<const HALF: usize>(
        &self,
        state: &State<S, N>,
        inputs: &[Self::Inputs],
        prepared: &Self::Prepared,
        unit: S,
        motion: &TaylorCoefficients<Phase<S, N>, HALF>,
    ) -> Option<TaylorCoefficients<Self::EventValues, HALF>> {
        let _ = (state, inputs, prepared, unit, motion);
        None
    }
}

/// What all dynamics of a model say of its events.
macro_rules! declared_events {
    () => {
        type Values = M::EventValues;

        fn names(&self) -> &'static [&'static str] {
            M::EVENTS
        }

        fn branches(&self, event: usize) -> &'static [usize] {
            M::BRANCHES.get(event).copied().unwrap_or_default()
        }
    };
}
pub(super) use declared_events;

/// The methods that both kinds of equations of motion have.
macro_rules! event_dynamics {
    () => {
        declared_events!();

        #[inline]
        fn event_functions(&self, t: S, x: &Phase<S, N>) -> M::EventValues {
            self.model
                .event_functions(&x.at(t), &self.inputs, &self.prepared)
        }

        #[inline]
        fn event_series<const HALF: usize>(
            &self,
            t: S,
            x: &Phase<S, N>,
            unit: S,
            motion: &TaylorCoefficients<Phase<S, N>, HALF>,
        ) -> Option<TaylorCoefficients<M::EventValues, HALF>> {
            let inputs = core::slice::from_ref(&self.inputs);
            self.model
                .event_series(&x.at(t), inputs, &self.prepared, unit, motion)
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

/// Under the inputs that the signals have.
impl<M, I, S, const N: usize, const U: usize> EventDynamics<S> for DrivenBy<'_, M, I, S, N, U>
where
    M: Inputs<N, U, S> + Events<N, S> + ?Sized,
    I: Signals<S, U>,
    S: Scalar,
{
    declared_events!();

    #[inline]
    fn event_functions(&self, t: S, x: &Phase<S, N>) -> M::EventValues {
        let inputs = self.inputs(t);
        self.model
            .event_functions(&x.at(t), &inputs, &self.prepared)
    }

    fn event_series<const HALF: usize>(
        &self,
        t: S,
        x: &Phase<S, N>,
        unit: S,
        motion: &TaylorCoefficients<Phase<S, N>, HALF>,
    ) -> Option<TaylorCoefficients<M::EventValues, HALF>> {
        let mut inputs = [[SVector::from_element(S::zero()); 2]; HALF];
        let inputs = inputs.as_flattened_mut();
        self.signals.series::<HALF>(t, unit, inputs);
        self.model
            .event_series(&x.at(t), inputs, &self.prepared, unit, motion)
    }
}

/// Under the inputs that the law sets, whose series are not known.
impl<M, C, R, S, const N: usize, const U: usize> EventDynamics<S>
    for ControlledBy<'_, M, C, S, N, U>
where
    M: Inputs<N, U, S> + Events<N, S> + ?Sized,
    C: Fn(&State<S, N>) -> R,
    R: IntoVector<S, U>,
    S: Scalar,
{
    declared_events!();

    #[inline]
    fn event_functions(&self, t: S, x: &Phase<S, N>) -> M::EventValues {
        let state = x.at(t);
        self.model
            .event_functions(&state, &self.inputs(&state), &self.prepared)
    }
}

/// Under the inputs that the controller sets, whose series are not known.
impl<M, C, R, Z, S, const N: usize, const U: usize, const K: usize> EventDynamics<S>
    for WithController<'_, M, C, S, N, U, K>
where
    M: Inputs<N, U, S> + Events<N, S> + ?Sized,
    C: Fn(&State<S, N>, &SVector<S, K>) -> (R, Z),
    R: IntoVector<S, U>,
    Z: IntoVector<S, K>,
    S: Scalar,
{
    declared_events!();

    #[inline]
    fn event_functions(&self, t: S, x: &AugmentedPhase<S, N, K>) -> M::EventValues {
        let state = x.at(t);
        let inputs = self.inputs(&state, &x.controller);
        self.model.event_functions(&state, &inputs, &self.prepared)
    }
}
