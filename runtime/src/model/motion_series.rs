//! The Taylor series of motions.

use super::equations_of_motion::{EquationsOfMotion, InputsOf};
use super::lagrangian::Lagrangian;
use super::law::{LawSeries, LawStates as _};
use super::phase::Phase;
use super::quantities::Quantities;
use super::state::State;
use crate::integrate::{
    BranchVisitor, MetConditions, Series, SeriesMemory, SwitchingFunction, TaylorCoefficients,
};
use crate::scalar::Scalar;

/// A model whose declaration has the clause `taylor`, with recurrences for the Taylor coefficients of its motions.
///
/// The recurrences solve for the accelerations like [`accelerations`](crate::Lagrangian::accelerations) if all pivots
/// are positive. If a pivot is 0, there is no series, even if M is regular.
#[diagnostic::on_unimplemented(
    message = "the Taylor series of the motions of `{Self}` is not known",
    note = "write the clause `taylor` in its declaration, `#[lagrangian(taylor, …)]`, or integrate by `Dop853`"
)]
pub trait MotionSeries<const N: usize, S: Scalar = f64>: Quantities<N, S> {
    /// Computes the Taylor polynomial of the motion through a state, in the given unit of time.
    ///
    /// The inputs are u(t + τ·unit) = Σ uₖ τᵏ; `inputs` holds the coefficients of order 0, 1, …, and missing ones are
    /// 0, so that a single coefficient is a held input. The terms of convolutions are kept in `memory`, if it is given.
    fn taylor_series<const HALF: usize>(
        &self,
        state: &State<S, N>,
        inputs: &[Self::Inputs],
        prepared: &Self::Prepared,
        unit: S,
        coefficients: &mut TaylorCoefficients<Phase<S, N>, HALF>,
        memory: Option<&mut SeriesMemory>,
    );

    /// The descriptions of the switching functions of [`branch_series`](Self::branch_series), in order.
    const SWITCHING_FUNCTIONS: &'static [SwitchingFunction] = &[];

    /// Visits the Taylor coefficients of each switching function along a motion through a state, under inputs with the
    /// given coefficients.
    ///
    /// The sign of a switching function distinguishes branches of the equations of motion; see [`Series::branches`].
    fn branch_series<const HALF: usize>(
        &self,
        state: &State<S, N>,
        inputs: &[Self::Inputs],
        prepared: &Self::Prepared,
        unit: S,
        motion: &TaylorCoefficients<Phase<S, N>, HALF>,
        visit: &mut BranchVisitor<'_, S>,
    ) {
        let _ = (state, inputs, prepared, unit, motion, visit);
    }

    /// Calls `visit` for each event function that is watched, with its index, its first Taylor coefficients along the motion through
    /// a state, and its value at the end of a step; see [`Series::events_in_step`]. `begin` is the state and the series of the
    /// inputs, `end` the state and the inputs at the end.
    fn events_in_step<const HALF: usize, const OF_MOTION: usize>(
        &self,
        begin: (&State<S, N>, &[Self::Inputs]),
        prepared: &Self::Prepared,
        unit: S,
        motion: &TaylorCoefficients<Phase<S, N>, OF_MOTION>,
        end: (&State<S, N>, &Self::Inputs),
        (watched, visit): (
            MetConditions,
            &mut impl FnMut(usize, &TaylorCoefficients<S, HALF>, S),
        ),
    ) {
        let _ = (begin, prepared, unit, motion, end, watched, visit);
    }
}

impl<M, S, const N: usize, L> Series<S> for EquationsOfMotion<M, S, N, L>
where
    M: Lagrangian<N, S, Model: MotionSeries<N, S>>,
    S: Scalar,
    L: LawSeries<N, InputsOf<M, S, N>, S>,
{
    #[inline]
    fn series<const HALF: usize>(
        &self,
        (t, x): (S, &Self::State),
        unit: S,
        coefficients: &mut TaylorCoefficients<Self::State, HALF>,
        memory: Option<&mut SeriesMemory>,
    ) {
        let (model, state) = (self.model.model(), x.at_time(t));
        self.law
            .series::<HALF, ()>(&self.inputs, (t, x), unit, |inputs, states| {
                L::States::expand(x, states, coefficients, |motion| {
                    model.taylor_series(&state, inputs, &self.prepared, unit, motion, memory);
                });
            });
    }

    fn branches<const HALF: usize>(
        &self,
        t: S,
        x: &Self::State,
        unit: S,
        motion: &TaylorCoefficients<Self::State, HALF>,
        visit: &mut BranchVisitor<'_, S>,
    ) {
        let (model, state) = (self.model.model(), x.at_time(t));
        self.law
            .series::<HALF, ()>(&self.inputs, (t, x), unit, |inputs, _| {
                L::States::of_motion(motion, |motion| {
                    model.branch_series(&state, inputs, &self.prepared, unit, motion, visit);
                });
            });
    }

    fn switching_function(&self, index: usize) -> SwitchingFunction {
        let functions = <M::Model as MotionSeries<N, S>>::SWITCHING_FUNCTIONS;
        functions.get(index).copied().unwrap_or_default()
    }

    #[inline]
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
        let (model, state) = (self.model.model(), x.at_time(t));
        let (inputs_at_end, _) = self.law.evaluate(&self.inputs, end, last);
        let end = (&last.at_time(end), &inputs_at_end);
        self.law
            .series::<HALF, ()>(&self.inputs, (t, x), unit, |inputs, _| {
                L::States::of_motion(motion, |motion| {
                    let begin = (&state, inputs);
                    let (prepared, visitor) = (&self.prepared, (watched, &mut *visit));
                    model.events_in_step(begin, prepared, unit, motion, end, visitor);
                });
            });
    }
}
