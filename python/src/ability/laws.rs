//! Inputs, which a function of Python sets.

use lagrangian::laws::{Feedback, SampledFeedback};
use lagrangian::nalgebra::SVector;
use lagrangian::quantities::{Inputs, Reflect};
use lagrangian::{Dynamics, EquationsOfMotion, Lagrangian, Problem, State};

use super::{Probe, Values};
use crate::numbers::rows;
use crate::request::{Law, Request};

/// A law that is a function of Python.
pub type PythonLaw<'a, const N: usize, const U: usize> =
    Box<dyn Fn(&State<f64, N>) -> SVector<f64, U> + 'a>;

/// A law that is a function of Python and called once per period.
pub type SampledPythonLaw<'a, const N: usize, const U: usize> =
    Box<dyn Fn(&State<f64, N>, &mut SVector<f64, 0>) -> SVector<f64, U> + 'a>;

/// The equations of motion of a model under a law.
pub type Under<'a, M, const N: usize, L> = EquationsOfMotion<&'a M, f64, N, L>;

/// Inputs.
pub trait HasInputs<M, const N: usize, const U: usize> {
    /// The input matrix.
    fn input_matrix(&self) -> Option<Values<M, N>>;

    /// The problem under feedback.
    fn feedback<'a>(
        &self,
        problem: Problem<f64, EquationsOfMotion<&'a M, f64, N>>,
        request: &'a Request,
    ) -> Option<Problem<f64, Under<'a, M, N, Feedback<PythonLaw<'a, N, U>, U>>>>
    where
        M: Lagrangian<N, Model: Inputs<N, U>>;

    /// The problem under sampled feedback.
    #[allow(clippy::type_complexity)] // The law is in the type of the problem.
    fn sampled_feedback<'a>(
        &self,
        problem: Problem<f64, EquationsOfMotion<&'a M, f64, N>>,
        request: &'a Request,
    ) -> Option<Problem<f64, Under<'a, M, N, SampledFeedback<SampledPythonLaw<'a, N, U>, U, 0>>>>
    where
        M: Lagrangian<N, Model: Inputs<N, U>>;
}

impl<M, const N: usize, const U: usize, const E: usize, const C: usize> HasInputs<M, N, U>
    for &Probe<M, N, U, E, C>
where
    M: Reflect<N, Model: Inputs<N, U>>,
{
    fn input_matrix(&self) -> Option<Values<M, N>> {
        Some(|model, state, numbers| {
            numbers.extend(core::iter::repeat_n(0.0, N * U));
            rows(&model.input_jacobian(state), numbers);
        })
    }

    fn feedback<'a>(
        &self,
        problem: Problem<f64, EquationsOfMotion<&'a M, f64, N>>,
        request: &'a Request,
    ) -> Option<Problem<f64, Under<'a, M, N, Feedback<PythonLaw<'a, N, U>, U>>>> {
        let Law::Feedback(function) = &request.law else {
            return None;
        };
        let law: PythonLaw<'a, N, U> = Box::new(|state| request.inputs(function, state));
        Some(problem.feedback(law))
    }

    fn sampled_feedback<'a>(
        &self,
        problem: Problem<f64, EquationsOfMotion<&'a M, f64, N>>,
        request: &'a Request,
    ) -> Option<Problem<f64, Under<'a, M, N, SampledFeedback<SampledPythonLaw<'a, N, U>, U, 0>>>>
    {
        let Law::Sampled(function, period) = &request.law else {
            return None;
        };
        let law: SampledPythonLaw<'a, N, U> = Box::new(|state, _| request.inputs(function, state));
        Some(problem.sampled_feedback(*period, SVector::zeros(), law))
    }
}

/// No inputs.
pub trait HasNoInputs<M, const N: usize> {
    /// Nothing.
    fn input_matrix(&self) -> Option<Values<M, N>> {
        None
    }

    /// Nothing.
    fn feedback<D: Dynamics<f64>>(
        &self,
        _: Problem<f64, D>,
        _: &Request,
    ) -> Option<Problem<f64, D>> {
        None
    }

    /// Nothing.
    fn sampled_feedback<D: Dynamics<f64>>(
        &self,
        _: Problem<f64, D>,
        _: &Request,
    ) -> Option<Problem<f64, D>> {
        None
    }
}

impl<M, const N: usize, const U: usize, const E: usize, const C: usize> HasNoInputs<M, N>
    for Probe<M, N, U, E, C>
{
}
