//! The Taylor series of motions.

use super::equations_of_motion::EquationsOfMotion;
use super::owned_equations::OwnedEquations;
use super::phase::Phase;
use super::quantities::Quantities;
use super::state::State;
use crate::integrate::{BranchVisitor, Series, SwitchingFunction, TaylorCoefficients};
use crate::scalar::Scalar;

/// A model whose declaration has the clause `taylor`: recurrences for the Taylor coefficients of its motions.
///
/// They solve for the accelerations as [`accelerations`](crate::Lagrangian::accelerations) does where all pivots are positive;
/// where a pivot is 0 there is no series, though M may be regular.
#[diagnostic::on_unimplemented(
    message = "the Taylor series of the motions of `{Self}` is not known",
    note = "write the clause `taylor` in its declaration, `#[lagrangian(taylor, …)]`, or integrate by `Dop853`"
)]
pub trait MotionSeries<const N: usize, S: Scalar = f64>: Quantities<N, S> {
    /// The Taylor polynomial of the motion through a state, in this unit of time, under the inputs u(t + τ·unit) = Σ uₖ τᵏ, of which `inputs` has
    /// the coefficients of order 0, 1, …. Those that it does not have are 0: a single one is held.
    fn taylor_series<const HALF: usize>(
        &self,
        state: &State<S, N>,
        inputs: &[Self::Inputs],
        prepared: &Self::Prepared,
        unit: S,
        coefficients: &mut TaylorCoefficients<Phase<S, N>, HALF>,
    );

    /// The switching functions of [`branch_series`](Self::branch_series), in order.
    const SWITCHING_FUNCTIONS: &'static [SwitchingFunction] = &[];

    /// The Taylor coefficients of each switching function, an argument whose sign distinguishes branches of the equations of
    /// motion, along a motion through a state ([`Series::branches`]) under inputs with these coefficients.
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
            let inputs = core::slice::from_ref(&self.inputs);
            self.model
                .taylor_series(&x.at(t), inputs, &self.prepared, unit, coefficients);
        }

        fn branches<const HALF: usize>(
            &self,
            t: S,
            x: &Phase<S, N>,
            unit: S,
            motion: &TaylorCoefficients<Phase<S, N>, HALF>,
            visit: &mut BranchVisitor<'_, S>,
        ) {
            let inputs = core::slice::from_ref(&self.inputs);
            self.model
                .branch_series(&x.at(t), inputs, &self.prepared, unit, motion, visit);
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
