//! Systems whose motions have Taylor series.

use super::branch_crossings::BranchVisitor;
use super::coefficients::TaylorCoefficients;
use super::series_memory::SeriesMemory;
use crate::integrate::dynamics::Dynamics;
use crate::integrate::event::MetConditions;
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
    /// Sets `coefficients` to the Taylor polynomial of the solution through `begin`, (t, x), in this unit of time.
    ///
    /// An [`Ensemble`](crate::Ensemble) keeps the `memory` from one series of its lanes to the next. The coefficients do not depend on
    /// it: a handwritten series ignores it, and a wrapper passes it on.
    fn series<const HALF: usize>(
        &self,
        begin: (S, &Self::State),
        unit: S,
        coefficients: &mut TaylorCoefficients<Self::State, HALF>,
        memory: Option<&mut SeriesMemory>,
    );

    /// Visits the Taylor coefficients of each switching function along the motion through (t, x) with the coefficients
    /// `motion`.
    ///
    /// A switching function is an argument whose sign distinguishes branches of the equations, such as u for |u| and
    /// u − v for max(u, v). If one changes its sign within a step, the series is compared with the equations after the
    /// change; if they differ, the step ends there, and the next one begins on the new branch.
    ///
    /// Only the coefficient of order 0 is read if `motion` is the series about another state.
    ///
    /// Without this method the equations are assumed to be smooth: a contact within a step may then be missed, and the
    /// motion cannot get past a jump.
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

    /// Returns the properties of the switching function with this index in the order of [`branches`](Self::branches).
    fn switching_function(&self, index: usize) -> SwitchingFunction {
        let _ = index;
        SwitchingFunction::default()
    }

    /// Calls `visit` for each function of [`EventDynamics`](crate::EventDynamics) that is watched, with its index, its first Taylor
    /// coefficients along the motion from `begin`, (t, x), with the coefficients `motion`, and its value at the end of a step.
    ///
    /// An [`Ensemble`](crate::Ensemble) thereby finds the lanes in which no event can occur, in all lanes at once. Without
    /// this method, the step of each lane is examined by itself.
    fn events_in_step<const HALF: usize, const OF_MOTION: usize>(
        &self,
        begin: (S, &Self::State),
        unit: S,
        motion: &TaylorCoefficients<Self::State, OF_MOTION>,
        end: (S, &Self::State),
        (watched, visit): (
            MetConditions,
            &mut impl FnMut(usize, &TaylorCoefficients<S, HALF>, S),
        ),
    ) {
        let _ = (begin, unit, motion, end, watched, visit);
    }
}

impl<S: Scalar, D: Series<S> + ?Sized> Series<S> for &D {
    #[inline]
    fn series<const HALF: usize>(
        &self,
        begin: (S, &Self::State),
        unit: S,
        coefficients: &mut TaylorCoefficients<Self::State, HALF>,
        memory: Option<&mut SeriesMemory>,
    ) {
        (**self).series(begin, unit, coefficients, memory);
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

    #[inline]
    fn events_in_step<const HALF: usize, const OF_MOTION: usize>(
        &self,
        begin: (S, &Self::State),
        unit: S,
        motion: &TaylorCoefficients<Self::State, OF_MOTION>,
        end: (S, &Self::State),
        (watched, visit): (
            MetConditions,
            &mut impl FnMut(usize, &TaylorCoefficients<S, HALF>, S),
        ),
    ) {
        (**self).events_in_step(begin, unit, motion, end, (watched, visit));
    }
}

/// The properties of a switching function.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SwitchingFunction {
    /// The name in error messages: the formula, such as `ẋ` for `signum(dot(x))`.
    pub name: &'static str,
    /// Whether other switching functions change branch where this one changes its sign, like x, which selects the
    /// branch of |x| − 1 in max(|x| − 1, 0). A step then ends there, so that each series belongs to one branch.
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
