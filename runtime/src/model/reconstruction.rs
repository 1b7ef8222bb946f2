//! A reduced model together with its ignorable coordinates, found by quadrature of their velocities along the motion.

use nalgebra::SVector;

use super::equations_of_motion::EquationsOfMotion;
use super::events::Events;
use super::motion_series::MotionSeries;
use super::phase::Phase;
use super::routhian::{Routhian, RouthianSeries};
use super::state::State;
use crate::integrate::{
    BranchVisitor, ComponentName, Dynamics, EventDynamics, MetConditions, Series, SeriesMemory,
    Singularity, SwitchingFunction, TaylorCoefficients,
};
use crate::linalg::ErrorTolerance;
use crate::model::law::LawStates as _;
use crate::scalar::Scalar;

/// The equations of motion of a reduced model with `N` coordinates, together with the velocities of the `K` ignorable
/// coordinates, on which nothing depends; constructed by [`Routhian::reconstruction`].
///
/// Its states hold the ignorable coordinates in [`z`](Phase::z). The quadratures take part in the error control and in
/// the dense output of every method. Under [`Taylor`](crate::Taylor), the series of the velocities are integrated term
/// by term.
#[derive(Clone, Debug)]
pub struct Reconstruction<'a, M, S, const N: usize, const K: usize>
where
    M: Routhian<N, K, S>,
    S: Scalar,
{
    reduced: EquationsOfMotion<&'a M, S, N>,
}

impl<'a, M, S, const N: usize, const K: usize> Reconstruction<'a, M, S, N, K>
where
    M: Routhian<N, K, S>,
    S: Scalar,
{
    pub(super) fn new(model: &'a M) -> Self {
        Self {
            reduced: EquationsOfMotion::new(model),
        }
    }

    /// Returns the state of the full model.
    pub fn full_state(&self, state: &State<S, N, SVector<S, K>>) -> M::FullState {
        self.reduced.model.full_state(&state.state(), &state.z)
    }
}

impl<M, S, const N: usize, const K: usize> Dynamics<S> for Reconstruction<'_, M, S, N, K>
where
    M: Routhian<N, K, S>,
    S: Scalar,
{
    type State = Phase<S, N, SVector<S, K>>;

    #[inline]
    fn derivative(&self, t: S, x: &Self::State) -> Self::State {
        let model = self.reduced.model;
        let velocities = model.eliminated_velocities(&x.at_time(t), &self.reduced.prepared);
        self.reduced.derivative(t, &x.motion()).with(velocities)
    }

    /// The size of an ignorable coordinate is at least 1, since the size of an angle does not matter.
    #[inline]
    fn allowed_error(&self, x: &Self::State, tolerance: &ErrorTolerance<S>) -> Self::State {
        let size = |z: S| tolerance.of_coordinate(z.abs().max(S::one()));
        let allowed = self.reduced.allowed_error(&x.motion(), tolerance);
        allowed.with(x.z.map(size))
    }

    #[inline]
    fn reduced(&self, x: &Self::State, compensation: &Self::State) -> Self::State {
        let reduced = self.reduced.reduced(&x.motion(), &compensation.motion());
        reduced.with(x.z)
    }

    #[inline]
    fn singularity(&self, t: S, x: &Self::State, min_pivot: f64) -> Option<Singularity> {
        self.reduced.singularity(t, &x.motion(), min_pivot)
    }

    #[inline]
    fn singularity_in_motion(&self, t: S, x: &Self::State, min_pivot: f64) -> Option<Singularity> {
        self.reduced
            .singularity_in_motion(t, &x.motion(), min_pivot)
    }

    #[inline]
    fn singularity_between(
        &self,
        before: &Self::State,
        (t, after): (S, &Self::State),
    ) -> Option<Singularity> {
        let (before, after) = (before.motion(), after.motion());
        self.reduced.singularity_between(&before, (t, &after))
    }

    fn vanishing_inertia(&self, t: S, x: &Self::State) -> Option<Singularity> {
        self.reduced.vanishing_inertia(t, &x.motion())
    }

    fn vanishing_inertia_in_lane(&self, lane: usize, t: S, x: &Self::State) -> Option<Singularity> {
        self.reduced.vanishing_inertia_in_lane(lane, t, &x.motion())
    }

    fn component_name(&self, index: usize) -> ComponentName {
        let ignorable = index.checked_sub(2 * N);
        match ignorable.and_then(|k| M::ELIMINATED.get(k).copied()) {
            Some(name) => ComponentName::Coordinate(name),
            None => self.reduced.component_name(index),
        }
    }
}

impl<M, S, const N: usize, const K: usize> Series<S> for Reconstruction<'_, M, S, N, K>
where
    M: RouthianSeries<N, K, S, Model: MotionSeries<N, S>>,
    S: Scalar,
{
    fn series<const HALF: usize>(
        &self,
        (t, x): (S, &Self::State),
        unit: S,
        coefficients: &mut TaylorCoefficients<Self::State, HALF>,
        memory: Option<&mut SeriesMemory>,
    ) {
        let state = x.at_time(t);
        let mut motion = TaylorCoefficients::<Phase<S, N>, HALF>::new(x.motion());
        self.reduced
            .series((t, &x.motion()), unit, &mut motion, memory);
        let model = self.reduced.model;
        let prepared = &self.reduced.prepared;
        let rates = model.ignorable_velocity_series(&state, prepared, unit, &motion);
        *coefficients.initial_mut() = motion.initial().with(x.z);
        // ∫ Σ uₖ τᵏ unit dτ = Σ unit uₖ₋₁/k τᵏ.
        let rates = core::iter::once(rates.initial()).chain(rates.higher());
        let terms = coefficients.higher_mut().iter_mut();
        let mut order = S::zero();
        for ((term, of_motion), rate) in terms.zip(motion.higher()).zip(rates) {
            order += S::one();
            let scale = unit / order;
            *term = of_motion.with(SVector::from(*rate).map(|rate| rate * scale));
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
        SVector::of_motion(motion, |motion| {
            self.reduced.branches(t, &x.motion(), unit, motion, visit);
        });
    }

    fn switching_function(&self, index: usize) -> SwitchingFunction {
        self.reduced.switching_function(index)
    }

    fn events_in_step<const HALF: usize, const OF_MOTION: usize>(
        &self,
        (t, x): (S, &Self::State),
        unit: S,
        motion: &TaylorCoefficients<Self::State, OF_MOTION>,
        (end, last): (S, &Self::State),
        (watched, visit): (
            MetConditions,
            &mut impl FnMut(usize, &TaylorCoefficients<S, HALF>, S),
        ),
    ) {
        let (begin, end) = ((t, &x.motion()), (end, &last.motion()));
        SVector::of_motion(motion, |motion| {
            self.reduced
                .events_in_step(begin, unit, motion, end, (watched, visit));
        });
    }
}

/// The events of the reduced model, which depend only on its state.
impl<M, S, const N: usize, const K: usize> EventDynamics<S> for Reconstruction<'_, M, S, N, K>
where
    M: Routhian<N, K, S, Model: Events<N, S>>,
    S: Scalar,
{
    type Model = M::Model;
    type Values = <M::Model as Events<N, S>>::EventValues;

    fn names(&self) -> &'static [&'static str] {
        self.reduced.names()
    }

    fn branches(&self, event: usize) -> &'static [usize] {
        EventDynamics::branches(&self.reduced, event)
    }

    #[inline]
    fn event_functions(&self, t: S, x: &Self::State) -> Self::Values {
        self.reduced.event_functions(t, &x.motion())
    }

    #[inline]
    fn event_series<const HALF: usize, const OF_MOTION: usize>(
        &self,
        t: S,
        x: &Self::State,
        unit: S,
        motion: &TaylorCoefficients<Self::State, OF_MOTION>,
    ) -> Option<TaylorCoefficients<Self::Values, HALF>> {
        SVector::of_motion(motion, |motion| {
            self.reduced.event_series(t, &x.motion(), unit, motion)
        })
    }
}
