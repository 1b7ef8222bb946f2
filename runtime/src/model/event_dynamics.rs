//! The events of a model in a motion.

use super::equations_of_motion::{EquationsOfMotion, InputsOf};
use super::events::Events;
use super::lagrangian::Lagrangian;
use super::law::{Law, LawStates as _};
use crate::integrate::{EventDynamics, TaylorCoefficients};
use crate::scalar::Scalar;

/// The inputs follow the law. Events have series if the inputs have series.
impl<M, S, const N: usize, L> EventDynamics<S> for EquationsOfMotion<M, S, N, L>
where
    M: Lagrangian<N, S, Model: Events<N, S>>,
    S: Scalar,
    L: Law<N, InputsOf<M, S, N>, S>,
{
    type Model = M::Model;
    type Values = <M::Model as Events<N, S>>::EventValues;

    fn names(&self) -> &'static [&'static str] {
        <M::Model as Events<N, S>>::EVENTS
    }

    fn branches(&self, event: usize) -> &'static [usize] {
        let branches = <M::Model as Events<N, S>>::BRANCHES;
        branches.get(event).copied().unwrap_or_default()
    }

    #[inline]
    fn event_functions(&self, t: S, x: &Self::State) -> Self::Values {
        let (inputs, _) = self.law.evaluate(&self.inputs, t, x);
        let model = self.model.model();
        model.event_functions(&x.at_time(t), &inputs, &self.prepared)
    }

    #[inline]
    fn event_series<const HALF: usize, const OF_MOTION: usize>(
        &self,
        t: S,
        x: &Self::State,
        unit: S,
        motion: &TaylorCoefficients<Self::State, OF_MOTION>,
    ) -> Option<TaylorCoefficients<Self::Values, HALF>> {
        let (model, state) = (self.model.model(), x.at_time(t));
        self.law
            .series::<HALF, _>(&self.inputs, (t, x), unit, |inputs, _| {
                L::States::of_motion(motion, |motion| {
                    model.event_series(&state, inputs, &self.prepared, unit, motion)
                })
            })
            .flatten()
    }
}
