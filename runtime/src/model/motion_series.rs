//! The Taylor series of motions.

use nalgebra::SVector;

use super::equations_of_motion::EquationsOfMotion;
use super::inputs::{Inputs, WithInputs};
use super::lagrangian::Lagrangian;
use super::owned_equations::OwnedEquations;
use super::phase::Phase;
use super::state::State;
use crate::integrate::{BranchVisitor, Series, SwitchingFunction, TaylorCoefficients};
use crate::scalar::Scalar;

/// A model whose declaration has the clause `taylor`: recurrences for the Taylor coefficients of its motions.
///
/// They solve for the accelerations as [`accelerations`](Lagrangian::accelerations) does where all pivots are positive;
/// where a pivot is 0 there is no series, though M may be regular.
#[diagnostic::on_unimplemented(
    message = "the Taylor series of the motions of `{Self}` is not known",
    note = "write the clause `taylor` in its declaration, `#[lagrangian(taylor, …)]`, or integrate by `Dop853`"
)]
pub trait MotionSeries<const N: usize, S: Scalar = f64>: Lagrangian<N, S> {
    /// The Taylor polynomial of the motion through a state, in this unit of time, given the result of
    /// [`prepare`](Lagrangian::prepare) for the same parameters.
    fn taylor_series<const HALF: usize>(
        &self,
        state: &State<S, N>,
        prepared: &Self::Prepared,
        unit: S,
        coefficients: &mut TaylorCoefficients<Phase<S, N>, HALF>,
    );

    /// The switching functions of [`branch_series`](Self::branch_series), in order.
    const SWITCHING_FUNCTIONS: &'static [SwitchingFunction] = &[];

    /// The Taylor coefficients of each switching function, an argument whose sign distinguishes branches of the equations of
    /// motion, along a motion through a state ([`Series::branches`]).
    fn branch_series<const HALF: usize>(
        &self,
        state: &State<S, N>,
        unit: S,
        motion: &TaylorCoefficients<Phase<S, N>, HALF>,
        visit: &mut BranchVisitor<'_, S>,
    ) {
        let _ = (state, unit, motion, visit);
    }
}

/// A model with inputs whose declaration has the clause `taylor`: the same recurrences, in which the inputs are functions
/// of time.
#[diagnostic::on_unimplemented(
    message = "the Taylor series of the motions of `{Self}` under inputs is not known",
    note = "write the clause `taylor` in its declaration, `#[lagrangian(taylor, …)]`, or integrate by `Dop853`"
)]
pub trait MotionSeriesWith<const N: usize, const U: usize, S: Scalar = f64>:
    Inputs<N, U, S> + MotionSeries<N, S>
{
    /// The Taylor polynomial of the motion through a state under the inputs u(t + τ·unit) = Σ uₖ τᵏ, of which `inputs` has
    /// the coefficients of order 0, 1, …. Those that it does not have are 0: a single one is held.
    fn taylor_series_with<const HALF: usize>(
        &self,
        state: &State<S, N>,
        inputs: &[SVector<S, U>],
        prepared: &Self::Prepared,
        unit: S,
        coefficients: &mut TaylorCoefficients<Phase<S, N>, HALF>,
    );

    /// The same as [`branch_series`](MotionSeries::branch_series), under inputs with these coefficients.
    fn branch_series_with<const HALF: usize>(
        &self,
        inputs: &[SVector<S, U>],
        state: &State<S, N>,
        unit: S,
        motion: &TaylorCoefficients<Phase<S, N>, HALF>,
        visit: &mut BranchVisitor<'_, S>,
    ) {
        let _ = (inputs, state, unit, motion, visit);
    }
}

/// Under inputs that are held.
impl<M, S, const N: usize, const U: usize> MotionSeries<N, S> for WithInputs<'_, M, S, U>
where
    M: MotionSeriesWith<N, U, S> + ?Sized,
    S: Scalar,
{
    const SWITCHING_FUNCTIONS: &'static [SwitchingFunction] = M::SWITCHING_FUNCTIONS;

    #[inline]
    fn taylor_series<const HALF: usize>(
        &self,
        state: &State<S, N>,
        prepared: &Self::Prepared,
        unit: S,
        coefficients: &mut TaylorCoefficients<Phase<S, N>, HALF>,
    ) {
        let held = [self.inputs];
        self.model
            .taylor_series_with(state, &held, prepared, unit, coefficients);
    }

    fn branch_series<const HALF: usize>(
        &self,
        state: &State<S, N>,
        unit: S,
        motion: &TaylorCoefficients<Phase<S, N>, HALF>,
        visit: &mut BranchVisitor<'_, S>,
    ) {
        let held = [self.inputs];
        self.model
            .branch_series_with(&held, state, unit, motion, visit);
    }
}

/// What is known of a switching function of a model.
pub(super) fn switching_function<M, S, const N: usize>(index: usize) -> SwitchingFunction
where
    M: MotionSeries<N, S> + ?Sized,
    S: Scalar,
{
    let function = M::SWITCHING_FUNCTIONS.get(index).copied();
    function.unwrap_or_default()
}

/// The series of equations of motion, of a model that they own or refer to.
macro_rules! series_of_the_model {
    () => {
        #[inline]
        fn series<const HALF: usize>(
            &self,
            t: S,
            x: &Phase<S, N>,
            unit: S,
            coefficients: &mut TaylorCoefficients<Phase<S, N>, HALF>,
        ) {
            self.model
                .taylor_series(&x.at(t), &self.prepared, unit, coefficients);
        }

        fn branches<const HALF: usize>(
            &self,
            t: S,
            x: &Phase<S, N>,
            unit: S,
            motion: &TaylorCoefficients<Phase<S, N>, HALF>,
            visit: &mut BranchVisitor<'_, S>,
        ) {
            self.model.branch_series(&x.at(t), unit, motion, visit);
        }

        fn switching_function(&self, index: usize) -> SwitchingFunction {
            switching_function::<M, S, N>(index)
        }
    };
}

impl<M, S, const N: usize> Series<S> for EquationsOfMotion<'_, M, S, N>
where
    M: MotionSeries<N, S> + ?Sized,
    S: Scalar,
{
    series_of_the_model!();
}

impl<M, S, const N: usize> Series<S> for OwnedEquations<M, S, N>
where
    M: MotionSeries<N, S>,
    S: Scalar,
{
    series_of_the_model!();
}
