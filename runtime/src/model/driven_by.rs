//! Models whose inputs are functions of time.

use nalgebra::SVector;

use super::common_dynamics::{errors_of_the_model, reduced};
use super::inputs::Inputs;
use super::motion_series::{MotionSeries, switching_function};
use super::phase::Phase;
use super::signals::Signals;
use super::state::State;
use crate::integrate::{BranchVisitor, Dynamics, Series, SwitchingFunction, TaylorCoefficients};
use crate::scalar::Scalar;

/// A system under inputs u(t) that are [`Signals`]; made by
/// [`Lagrangian::driven_by`](crate::Lagrangian::driven_by).
///
/// The quantities that depend on parameters only are computed when it is made.
#[derive(Debug)]
pub struct DrivenBy<'a, M, I, S, const N: usize, const U: usize>
where
    M: Inputs<N, U, S> + ?Sized,
    S: Scalar,
{
    pub(super) model: &'a M,
    pub(super) prepared: M::Prepared,
    pub(super) signals: I,
}

impl<M, I, S, const N: usize, const U: usize> Clone for DrivenBy<'_, M, I, S, N, U>
where
    M: Inputs<N, U, S> + ?Sized,
    I: Clone,
    S: Scalar,
{
    fn clone(&self) -> Self {
        Self {
            model: self.model,
            prepared: self.prepared.clone(),
            signals: self.signals.clone(),
        }
    }
}

impl<'a, M, I, S, const N: usize, const U: usize> DrivenBy<'a, M, I, S, N, U>
where
    M: Inputs<N, U, S> + ?Sized,
    I: Signals<S, U>,
    S: Scalar,
{
    pub(super) fn new(model: &'a M, signals: I) -> Self {
        Self {
            model,
            prepared: model.prepare(),
            signals,
        }
    }

    /// The inputs u(t).
    #[inline]
    pub fn inputs(&self, t: S) -> SVector<S, U> {
        self.signals.values(t)
    }
}

impl<M, I, S, const N: usize, const U: usize> Dynamics<S> for DrivenBy<'_, M, I, S, N, U>
where
    M: Inputs<N, U, S> + ?Sized,
    I: Signals<S, U>,
    S: Scalar,
{
    type State = Phase<S, N>;

    #[inline]
    fn derivative(&self, t: S, x: &Phase<S, N>) -> Phase<S, N> {
        let (state, inputs) = (x.at(t), self.signals.values(t));
        Phase {
            q: x.v,
            v: self.model.accelerations(&state, &inputs, &self.prepared),
        }
    }

    #[inline]
    fn reduced(&self, x: &Phase<S, N>, compensation: &Phase<S, N>) -> Phase<S, N> {
        reduced::<M, S, N>(x, compensation)
    }

    errors_of_the_model!();
}

impl<M, I, S, const N: usize, const U: usize> Series<S> for DrivenBy<'_, M, I, S, N, U>
where
    M: Inputs<N, U, S> + MotionSeries<N, S> + ?Sized,
    I: Signals<S, U>,
    S: Scalar,
{
    fn series<const HALF: usize>(
        &self,
        t: S,
        x: &Phase<S, N>,
        unit: S,
        coefficients: &mut TaylorCoefficients<Phase<S, N>, HALF>,
    ) {
        let state: State<S, N> = x.at(t);
        let mut inputs = [[SVector::from_element(S::zero()); 2]; HALF];
        let inputs = inputs.as_flattened_mut();
        self.signals.series::<HALF>(t, unit, inputs);
        self.model
            .taylor_series(&state, inputs, &self.prepared, unit, coefficients);
    }

    fn branches<const HALF: usize>(
        &self,
        t: S,
        x: &Phase<S, N>,
        unit: S,
        motion: &TaylorCoefficients<Phase<S, N>, HALF>,
        visit: &mut BranchVisitor<'_, S>,
    ) {
        let mut inputs = [[SVector::from_element(S::zero()); 2]; HALF];
        let inputs = inputs.as_flattened_mut();
        self.signals.series::<HALF>(t, unit, inputs);
        self.model
            .branch_series(&x.at(t), inputs, &self.prepared, unit, motion, visit);
    }

    fn switching_function(&self, index: usize) -> SwitchingFunction {
        switching_function::<M, S, N>(index)
    }
}
