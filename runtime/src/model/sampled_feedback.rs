//! Sampled feedback: a controller that is evaluated periodically, and whose inputs are held in between.

use nalgebra::SVector;

use super::common_dynamics::{allowed_error, component_name, reduced, singularities_of_the_model};
use super::events::{Events, declared_events};
use super::inputs::Inputs;
use super::motion_series::{MotionSeries, switching_function};
use super::phase::Phase;
use super::sampled_phase::SampledPhase;
use super::state::State;
use crate::integrate::{
    BranchVisitor, ComponentName, Dynamics, EventDynamics, Series, SingleNumber, SwitchingFunction,
    TaylorCoefficients,
};
use crate::linalg::{ErrorTolerance, IntoVector, VectorSpace};
use crate::scalar::Scalar;

/// A model under a controller that is sampled with a zero-order hold; made by
/// [`Problem::sampled_feedback`](crate::Problem::sampled_feedback).
#[derive(Debug)]
pub struct SampledFeedback<'a, M, F, S, const N: usize, const U: usize, const J: usize>
where
    M: Inputs<N, U, S>,
    S: Scalar,
{
    model: &'a M,
    prepared: M::Prepared,
    law: F,
    /// The time of the first sampling.
    start: f64,
    period: f64,
}

impl<M, F, S, const N: usize, const U: usize, const J: usize> Clone
    for SampledFeedback<'_, M, F, S, N, U, J>
where
    M: Inputs<N, U, S>,
    F: Clone,
    S: Scalar,
{
    fn clone(&self) -> Self {
        Self {
            model: self.model,
            prepared: self.prepared.clone(),
            law: self.law.clone(),
            start: self.start,
            period: self.period,
        }
    }
}

impl<'a, M, F, S, const N: usize, const U: usize, const J: usize>
    SampledFeedback<'a, M, F, S, N, U, J>
where
    M: Inputs<N, U, S>,
    S: Scalar,
{
    pub(super) fn new(model: &'a M, law: F, start: f64, period: f64) -> Self {
        Self {
            model,
            prepared: model.prepare(),
            law,
            start,
            period,
        }
    }
}

impl<M, F, R, S, const N: usize, const U: usize, const J: usize> Dynamics<S>
    for SampledFeedback<'_, M, F, S, N, U, J>
where
    M: Inputs<N, U, S>,
    F: Fn(&State<S, N>, &mut SVector<S, J>) -> R,
    R: IntoVector<S, U>,
    S: Scalar,
{
    type State = SampledPhase<S, N, U, J>;

    #[inline]
    fn derivative(&self, t: S, x: &Self::State) -> Self::State {
        SampledPhase::moving(Phase {
            q: x.v,
            v: self
                .model
                .accelerations(&x.at(t), &x.inputs, &self.prepared),
        })
    }

    /// The next multiple of the period.
    fn next_update(&self, x: &Self::State) -> Option<f64> {
        let time = self.start + x.samplings.smallest() * self.period;
        // Without a period that is a number the time is not one, which is an error.
        let is_valid = self.period > 0.0 && self.period.is_finite();
        Some(if is_valid { time } else { f64::NAN })
    }

    fn update(&self, t: S, x: &mut Self::State) {
        x.inputs = (self.law)(&x.at(t), &mut x.memory).into_vector();
        x.samplings += S::one();
    }

    #[inline]
    fn allowed_error(&self, x: &Self::State, tolerance: &ErrorTolerance<S>) -> Self::State {
        let Phase { q, v } = allowed_error::<M, S, N>(&x.phase(), tolerance);
        let of_held = VectorSpace::map(x, |held| tolerance.of_coordinate(held.abs()));
        SampledPhase { q, v, ..of_held }
    }

    /// The controller is evaluated at the whole angles.
    #[inline]
    fn reduced(&self, x: &Self::State, compensation: &Self::State) -> Self::State {
        let Phase { q, v } = reduced::<M, S, N>(&x.phase(), &compensation.phase());
        SampledPhase { q, v, ..*x }
    }

    singularities_of_the_model!();

    fn component_name(&self, index: usize) -> ComponentName {
        match index.checked_sub(2 * N) {
            Some(own) => ComponentName::Controller(own),
            None => component_name::<M, N>(index),
        }
    }
}

/// Between two samplings the inputs are constant. Motions in lanes have samplings of their own, which nothing waits for: they
/// have no series.
impl<M, F, R, S, const N: usize, const U: usize, const J: usize> Series<S>
    for SampledFeedback<'_, M, F, S, N, U, J>
where
    M: Inputs<N, U, S> + MotionSeries<N, S>,
    F: Fn(&State<S, N>, &mut SVector<S, J>) -> R,
    R: IntoVector<S, U>,
    S: SingleNumber,
{
    fn series<const HALF: usize>(
        &self,
        t: S,
        x: &Self::State,
        unit: S,
        coefficients: &mut TaylorCoefficients<Self::State, HALF>,
    ) {
        let (state, held) = (x.at(t), [x.inputs]);
        let mut motion = TaylorCoefficients::<Phase<S, N>, HALF>::new(x.phase());
        self.model
            .taylor_series(&state, &held, &self.prepared, unit, &mut motion);
        *coefficients = motion.map(|term| SampledPhase::moving(*term));
        *coefficients.initial_mut() = *x;
    }

    fn branches<const HALF: usize>(
        &self,
        t: S,
        x: &Self::State,
        unit: S,
        motion: &TaylorCoefficients<Self::State, HALF>,
        visit: &mut BranchVisitor<'_, S>,
    ) {
        let held = [x.inputs];
        self.model.branch_series(
            &x.at(t),
            &held,
            &self.prepared,
            unit,
            &motion.map(SampledPhase::phase),
            visit,
        );
    }

    fn switching_function(&self, index: usize) -> SwitchingFunction {
        switching_function::<M, S, N>(index)
    }
}

impl<M, F, R, S, const N: usize, const U: usize, const J: usize> EventDynamics<S>
    for SampledFeedback<'_, M, F, S, N, U, J>
where
    M: Inputs<N, U, S> + Events<N, S>,
    F: Fn(&State<S, N>, &mut SVector<S, J>) -> R,
    R: IntoVector<S, U>,
    S: Scalar,
{
    declared_events!();

    #[inline]
    fn event_functions(&self, t: S, x: &Self::State) -> M::EventValues {
        self.model
            .event_functions(&x.at(t), &x.inputs, &self.prepared)
    }

    fn event_series<const HALF: usize>(
        &self,
        t: S,
        x: &Self::State,
        unit: S,
        motion: &TaylorCoefficients<Self::State, HALF>,
    ) -> Option<TaylorCoefficients<M::EventValues, HALF>> {
        let held = [x.inputs];
        let motion = motion.map(SampledPhase::phase);
        self.model
            .event_series(&x.at(t), &held, &self.prepared, unit, &motion)
    }
}
