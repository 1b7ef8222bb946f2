//! Systems whose motions have Taylor series.

use super::branch_crossings::BranchVisitor;
use super::coefficients::TaylorCoefficients;
use crate::integrate::dynamics::Dynamics;
use crate::scalar::Scalar;

/// A system of differential equations with recurrences for the Taylor coefficients of its solutions.
#[diagnostic::on_unimplemented(
    message = "the Taylor series of `{Self}` is not known",
    note = "a model has one with the clause `taylor` in its declaration",
    note = "a control law has none: integrate by `Dop853`, or take `sampled_feedback`, or write the law under `force`; inputs that are functions of time are signals, `driven_by([signal])`, inputs that are held are \
            `model.with_inputs([value])`; a model with a type parameter has one on `Lanes` if its parameters are `Lanes`, or `f64`; Hamilton's equations have the motion of `model.dynamics()`, with \
            `model.momenta(&state)`; other systems implement `Series` with the blocks of `recurrences`; `Dop853` integrates all \
            others"
)]
pub trait Series<S: Scalar = f64>: Dynamics<S> {
    /// The Taylor polynomial of the solution through (t, x), in this unit of time.
    fn series<const HALF: usize>(
        &self,
        t: S,
        x: &Self::State,
        unit: S,
        coefficients: &mut TaylorCoefficients<Self::State, HALF>,
    );

    /// The Taylor coefficients, along the motion through (t, x) with these coefficients, of each switching function: an argument
    /// whose sign distinguishes branches of the equations, such as u for |u| and u − v for max(u, v). Where one changes its sign
    /// within a step, the series is compared with the equations behind it; where they differ, the step ends there, and the next
    /// one begins on the branch behind.
    ///
    /// Only the coefficient of order 0 is asked for where `motion` is the series about another state.
    ///
    /// Without this method the equations are taken for smooth: a contact within a step may then be passed over, and a jump is
    /// not passed.
    fn branches<const HALF: usize>(
        &self,
        t: S,
        x: &Self::State,
        unit: S,
        motion: &TaylorCoefficients<Self::State, HALF>,
        visit: &mut BranchVisitor<'_, S>,
    ) {
        let _ = (t, x, unit, motion, visit);
    }

    /// What is known of the switching function of an index, for which [`branches`](Self::branches) visits the coefficients.
    fn switching_function(&self, index: usize) -> SwitchingFunction {
        let _ = index;
        SwitchingFunction::default()
    }
}

impl<S: Scalar, D: Series<S> + ?Sized> Series<S> for &D {
    #[inline]
    fn series<const HALF: usize>(
        &self,
        t: S,
        x: &Self::State,
        unit: S,
        coefficients: &mut TaylorCoefficients<Self::State, HALF>,
    ) {
        (**self).series(t, x, unit, coefficients);
    }

    fn branches<const HALF: usize>(
        &self,
        t: S,
        x: &Self::State,
        unit: S,
        motion: &TaylorCoefficients<Self::State, HALF>,
        visit: &mut BranchVisitor<'_, S>,
    ) {
        (**self).branches(t, x, unit, motion, visit);
    }

    fn switching_function(&self, index: usize) -> SwitchingFunction {
        (**self).switching_function(index)
    }
}

/// What is known of a switching function.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SwitchingFunction {
    /// What it is called in error messages: its formula, such as `ẋ` for `signum(dot(x))`.
    pub name: &'static str,
    /// Whether other switching functions have other branches where it changes its sign, as max(|x| − 1, 0) has for x. A step
    /// then ends there, so that their series are those of their branches.
    pub is_inner: bool,
}

impl Default for SwitchingFunction {
    fn default() -> Self {
        Self {
            name: "a switching function",
            is_inner: false,
        }
    }
}
