//! Models whose inputs are functions of time.

use nalgebra::SVector;

use super::equations_of_motion::{
    allowed_error, component_name, reduced, singularity, singularity_in_lane, vanishing_inertia,
    vanishing_inertia_in_lane,
};
use super::inputs::Inputs;
use super::motion_series::MotionSeriesWith;
use super::phase::Phase;
use super::signals::Signals;
use super::state::State;
use crate::integrate::{ComponentName, Dynamics, Series, Singularity, TaylorCoefficients};
use crate::linalg::ErrorTolerance;
use crate::scalar::Scalar;

/// A system under inputs u(t) that are [`Signals`]; made by [`Inputs::driven_by`].
///
/// The quantities that depend on parameters only are computed when it is made.
#[derive(Debug)]
pub struct DrivenBy<'a, M, I, S, const N: usize, const U: usize>
where
    M: Inputs<N, U, S> + ?Sized,
    S: Scalar,
{
    model: &'a M,
    prepared: M::Prepared,
    signals: I,
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
            v: self
                .model
                .accelerations_prepared_with(&state, &inputs, &self.prepared),
        }
    }

    #[inline]
    fn allowed_error(&self, x: &Phase<S, N>, tolerance: &ErrorTolerance<S>) -> Phase<S, N> {
        allowed_error::<M, S, N>(x, tolerance)
    }

    #[inline]
    fn reduced(&self, x: &Phase<S, N>, compensation: &Phase<S, N>) -> Phase<S, N> {
        reduced::<M, S, N>(x, compensation)
    }

    #[inline]
    fn singularity(&self, t: S, x: &Phase<S, N>, min_pivot: f64) -> Option<Singularity> {
        singularity(self.model, &x.at(t), min_pivot)
    }

    fn vanishing_inertia(&self, t: S, x: &Phase<S, N>) -> Option<Singularity> {
        vanishing_inertia(self.model, &x.at(t))
    }

    #[inline]
    fn singularity_in_lane(
        &self,
        lane: usize,
        t: S,
        x: &Phase<S, N>,
        min_pivot: f64,
    ) -> Option<Singularity> {
        singularity_in_lane(self.model, lane, &x.at(t), min_pivot)
    }

    fn vanishing_inertia_in_lane(&self, lane: usize, t: S, x: &Phase<S, N>) -> Option<Singularity> {
        vanishing_inertia_in_lane(self.model, lane, &x.at(t))
    }

    fn component_name(&self, index: usize) -> ComponentName {
        component_name::<M, N>(index)
    }
}

impl<M, I, S, const N: usize, const U: usize> Series<S> for DrivenBy<'_, M, I, S, N, U>
where
    M: MotionSeriesWith<N, U, S> + ?Sized,
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
            .taylor_series_with(&state, inputs, &self.prepared, unit, coefficients);
    }
}
