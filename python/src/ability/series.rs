//! Taylor series.

use lagrangian::problem::{End, EnsembleIntegrator, Keep, Observer, Reactions, Watched};
use lagrangian::quantities::MotionSeries;
use lagrangian::{At, Dynamics, Integrator, Phase, Problem, Taylor};

use super::Probe;
use crate::ensemble::{Ensemble, EnsembleMotions};
use crate::integrated::Integrated;
use crate::request::Request;

/// The clause `taylor`.
pub trait HasTaylorSeries {
    /// Whether the model has it.
    fn has_taylor(&self) -> bool;

    /// Integrates a problem by Taylor series.
    fn by_taylor<D, C, R, O, Z, const N: usize>(
        &self,
        problem: Problem<f64, D, End, C, R, O>,
        request: &Request,
    ) -> Option<Integrated>
    where
        D: Dynamics<f64, State = Phase<f64, N, Z>>,
        Z: Clone,
        Taylor: Integrator<f64, D>,
        C: Watched<f64, D>,
        R: Reactions<f64, D>,
        O: Observer<D::State>,
        Vec<f64>:
            Keep<f64, D, <Taylor as Integrator<f64, D>>::Stepper, Kept = Vec<At<f64, D::State>>>;

    /// Integrates an ensemble by Taylor series in lanes.
    fn ensemble_by_taylor<D, C, R, O, Z, const N: usize>(
        &self,
        problem: impl Fn(usize) -> Problem<f64, D, Vec<f64>, C, R, O> + Sync,
        ensemble: &Ensemble,
    ) -> Option<Result<EnsembleMotions, String>>
    where
        D: Dynamics<f64, State = Phase<f64, N, Z>>,
        Z: Send,
        Taylor: EnsembleIntegrator<f64, D, 4>,
        C: Watched<f64, D>,
        R: Reactions<f64, D>,
        O: Observer<D::State>,
        Vec<f64>:
            Keep<f64, D, <Taylor as Integrator<f64, D>>::Stepper, Kept = Vec<At<f64, D::State>>>;
}

impl<M, const DEGREES: usize, const U: usize, const E: usize, const K: usize> HasTaylorSeries
    for &Probe<M, DEGREES, U, E, K>
where
    M: MotionSeries<DEGREES>,
{
    fn has_taylor(&self) -> bool {
        true
    }

    fn by_taylor<D, C, R, O, Z, const N: usize>(
        &self,
        problem: Problem<f64, D, End, C, R, O>,
        request: &Request,
    ) -> Option<Integrated>
    where
        D: Dynamics<f64, State = Phase<f64, N, Z>>,
        Z: Clone,
        Taylor: Integrator<f64, D>,
        C: Watched<f64, D>,
        R: Reactions<f64, D>,
        O: Observer<D::State>,
        Vec<f64>:
            Keep<f64, D, <Taylor as Integrator<f64, D>>::Stepper, Kept = Vec<At<f64, D::State>>>,
    {
        Some(request.solve(problem, request.settings.taylor()))
    }

    fn ensemble_by_taylor<D, C, R, O, Z, const N: usize>(
        &self,
        problem: impl Fn(usize) -> Problem<f64, D, Vec<f64>, C, R, O> + Sync,
        ensemble: &Ensemble,
    ) -> Option<Result<EnsembleMotions, String>>
    where
        D: Dynamics<f64, State = Phase<f64, N, Z>>,
        Z: Send,
        Taylor: EnsembleIntegrator<f64, D, 4>,
        C: Watched<f64, D>,
        R: Reactions<f64, D>,
        O: Observer<D::State>,
        Vec<f64>:
            Keep<f64, D, <Taylor as Integrator<f64, D>>::Stepper, Kept = Vec<At<f64, D::State>>>,
    {
        Some(ensemble.solve(problem, ensemble.settings.taylor()))
    }
}

/// No clause `taylor`.
pub trait HasNoTaylorSeries {
    /// It does not.
    fn has_taylor(&self) -> bool {
        false
    }

    /// Nothing.
    fn by_taylor<P>(&self, _: P, _: &Request) -> Option<Integrated> {
        None
    }

    /// Nothing.
    fn ensemble_by_taylor<P>(&self, _: P, _: &Ensemble) -> Option<Result<EnsembleMotions, String>> {
        None
    }
}

impl<M, const N: usize, const U: usize, const E: usize, const C: usize> HasNoTaylorSeries
    for Probe<M, N, U, E, C>
{
}
