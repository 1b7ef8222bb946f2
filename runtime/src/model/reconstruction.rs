//! A reduced model with its ignorable coordinates, by quadrature of their velocities along the motion.

use nalgebra::SVector;

use super::common_dynamics::{allowed_error, component_name, reduced, singularities_of_the_model};
use super::events::Events;
use super::motion_series::{MotionSeries, switching_function};
use super::phase::Phase;
use super::quantities::Quantities;
use super::reconstructed_phase::ReconstructedPhase;
use super::routhian::{Routhian, RouthianSeries};
use crate::integrate::{
    BranchVisitor, ComponentName, Dynamics, EventDynamics, Series, SwitchingFunction,
    TaylorCoefficients,
};
use crate::linalg::ErrorTolerance;
use crate::scalar::Scalar;

/// The equations of motion of a reduced model with `N` coordinates, and the velocities of the `K` ignorable ones, on which
/// nothing depends; made by [`Routhian::reconstruction`].
///
/// The quadratures take part in the control of errors, and in the dense output of every method. Under
/// [`Taylor`](crate::Taylor) the series of the velocities are integrated term by term.
#[derive(Debug)]
pub struct Reconstruction<'a, M, S, const N: usize, const K: usize>
where
    M: Routhian<N, K, S>,
    S: Scalar,
{
    model: &'a M,
    inputs: M::Inputs,
    prepared: M::Prepared,
}

impl<M, S, const N: usize, const K: usize> Clone for Reconstruction<'_, M, S, N, K>
where
    M: Routhian<N, K, S>,
    S: Scalar,
{
    fn clone(&self) -> Self {
        Self {
            model: self.model,
            inputs: self.inputs.clone(),
            prepared: self.prepared.clone(),
        }
    }
}

impl<'a, M, S, const N: usize, const K: usize> Reconstruction<'a, M, S, N, K>
where
    M: Routhian<N, K, S>,
    S: Scalar,
{
    pub(super) fn new(model: &'a M) -> Self {
        Self {
            model,
            inputs: Quantities::inputs(model),
            prepared: model.prepare(),
        }
    }

    /// The state of the full model at a time.
    pub fn full_state(&self, t: S, x: &ReconstructedPhase<S, N, K>) -> M::FullState {
        self.model.full_state(&x.at(t), &x.ignorable)
    }
}

/// A phase with its ignorable coordinates.
fn joined<S: Scalar, const N: usize, const K: usize>(
    phase: Phase<S, N>,
    ignorable: SVector<S, K>,
) -> ReconstructedPhase<S, N, K> {
    let Phase { q, v } = phase;
    ReconstructedPhase { q, v, ignorable }
}

impl<M, S, const N: usize, const K: usize> Dynamics<S> for Reconstruction<'_, M, S, N, K>
where
    M: Routhian<N, K, S>,
    S: Scalar,
{
    type State = ReconstructedPhase<S, N, K>;

    #[inline]
    fn derivative(&self, t: S, x: &Self::State) -> Self::State {
        let state = x.at(t);
        ReconstructedPhase {
            q: x.v,
            v: Quantities::accelerations(self.model, &state, &self.inputs, &self.prepared),
            ignorable: self.model.eliminated_velocities(&state, &self.prepared),
        }
    }

    /// The size of an ignorable coordinate is at least 1, since that of an angle does not matter.
    #[inline]
    fn allowed_error(&self, x: &Self::State, tolerance: &ErrorTolerance<S>) -> Self::State {
        let phase = allowed_error::<M, S, N>(&x.phase(), tolerance);
        let size = |z: S| tolerance.of_coordinate(z.abs().max(S::one()));
        joined(phase, x.ignorable.map(size))
    }

    #[inline]
    fn reduced(&self, x: &Self::State, compensation: &Self::State) -> Self::State {
        let phase = reduced::<M, S, N>(&x.phase(), &compensation.phase());
        joined(phase, x.ignorable)
    }

    singularities_of_the_model!();

    fn component_name(&self, index: usize) -> ComponentName {
        let ignorable = index.checked_sub(2 * N);
        match ignorable.and_then(|k| M::ELIMINATED.get(k).copied()) {
            Some(name) => ComponentName::Coordinate(name),
            None => component_name::<M, N>(index),
        }
    }
}

impl<M, S, const N: usize, const K: usize> Series<S> for Reconstruction<'_, M, S, N, K>
where
    M: RouthianSeries<N, K, S> + MotionSeries<N, S>,
    S: Scalar,
{
    fn series<const HALF: usize>(
        &self,
        t: S,
        x: &Self::State,
        unit: S,
        coefficients: &mut TaylorCoefficients<Self::State, HALF>,
    ) {
        let state = x.at(t);
        let mut motion = TaylorCoefficients::<Phase<S, N>, HALF>::new(x.phase());
        let inputs = core::slice::from_ref(&self.inputs);
        self.model
            .taylor_series(&state, inputs, &self.prepared, unit, &mut motion);
        let rates = self
            .model
            .ignorable_velocity_series(&state, &self.prepared, unit, &motion);
        *coefficients.initial_mut() = joined(*motion.initial(), x.ignorable);
        // ∫ Σ uₖ τᵏ unit dτ = Σ unit uₖ₋₁/k τᵏ.
        let rates = core::iter::once(rates.initial()).chain(rates.higher());
        let terms = coefficients.higher_mut().iter_mut();
        let mut order = S::zero();
        for ((term, of_motion), rate) in terms.zip(motion.higher()).zip(rates) {
            order += S::one();
            let scale = unit / order;
            *term = joined(*of_motion, SVector::from(*rate).map(|rate| rate * scale));
        }
    }

    fn branches<const HALF: usize>(
        &self,
        t: S,
        x: &Self::State,
        unit: S,
        motion: &TaylorCoefficients<Self::State, HALF>,
        visit: &mut BranchVisitor<'_, S>,
    ) {
        let of_phase = motion.map(ReconstructedPhase::phase);
        let inputs = core::slice::from_ref(&self.inputs);
        self.model
            .branch_series(&x.at(t), inputs, &self.prepared, unit, &of_phase, visit);
    }

    fn switching_function(&self, index: usize) -> SwitchingFunction {
        switching_function::<M, S, N>(index)
    }
}

/// The events of the reduced model: they depend on its state alone.
impl<M, S, const N: usize, const K: usize> EventDynamics<S> for Reconstruction<'_, M, S, N, K>
where
    M: Routhian<N, K, S> + Events<N, S>,
    S: Scalar,
{
    type Values = M::EventValues;

    fn names(&self) -> &'static [&'static str] {
        M::EVENTS
    }

    #[inline]
    fn event_functions(&self, t: S, x: &Self::State) -> M::EventValues {
        Events::event_functions(self.model, &x.at(t), &self.inputs, &self.prepared)
    }

    #[inline]
    fn event_series<const HALF: usize>(
        &self,
        t: S,
        x: &Self::State,
        unit: S,
        motion: &TaylorCoefficients<Self::State, HALF>,
    ) -> Option<TaylorCoefficients<M::EventValues, HALF>> {
        let inputs = core::slice::from_ref(&self.inputs);
        let of_phase = motion.map(ReconstructedPhase::phase);
        self.model
            .event_series(&x.at(t), inputs, &self.prepared, unit, &of_phase)
    }
}
