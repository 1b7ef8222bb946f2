//! Static state feedback.

use nalgebra::SVector;

use super::common_dynamics::errors_of_the_model;
use super::inputs::Inputs;
use super::phase::Phase;
use super::state::State;
use crate::integrate::Dynamics;
use crate::linalg::IntoVector;
use crate::scalar::Scalar;

/// A system under the static feedback u = law(t, q, q̇); made by
/// [`Plant::controlled_by`](crate::Plant::controlled_by).
///
/// The quantities that depend on parameters only are computed when it is made.
#[derive(Debug)]
pub struct ControlledBy<'a, M, C, S, const N: usize, const U: usize>
where
    M: Inputs<N, U, S> + ?Sized,
    S: Scalar,
{
    pub(super) model: &'a M,
    pub(super) prepared: M::Prepared,
    law: C,
}

impl<M, C, S, const N: usize, const U: usize> Clone for ControlledBy<'_, M, C, S, N, U>
where
    M: Inputs<N, U, S> + ?Sized,
    C: Clone,
    S: Scalar,
{
    fn clone(&self) -> Self {
        Self {
            model: self.model,
            prepared: self.prepared.clone(),
            law: self.law.clone(),
        }
    }
}

impl<'a, M, C, S, const N: usize, const U: usize> ControlledBy<'a, M, C, S, N, U>
where
    M: Inputs<N, U, S> + ?Sized,
    S: Scalar,
{
    /// The model under a law on any scalar on which the model is evaluated, such as
    /// `|state: &State<f32, 2>| …`.
    pub fn new<R>(model: &'a M, law: C) -> Self
    where
        C: Fn(&State<S, N>) -> R,
        R: IntoVector<S, U>,
    {
        Self {
            model,
            prepared: model.prepare(),
            law,
        }
    }

    /// The inputs u that the law sets at a state.
    #[inline]
    pub fn inputs<R>(&self, state: &State<S, N>) -> SVector<S, U>
    where
        C: Fn(&State<S, N>) -> R,
        R: IntoVector<S, U>,
    {
        (self.law)(state).into_vector()
    }
}

impl<M, C, R, S, const N: usize, const U: usize> Dynamics<S> for ControlledBy<'_, M, C, S, N, U>
where
    M: Inputs<N, U, S> + ?Sized,
    C: Fn(&State<S, N>) -> R,
    R: IntoVector<S, U>,
    S: Scalar,
{
    type State = Phase<S, N>;

    #[inline]
    fn derivative(&self, t: S, x: &Phase<S, N>) -> Phase<S, N> {
        let state = x.at(t);
        let inputs = self.inputs(&state);
        Phase {
            q: x.v,
            v: self.model.accelerations(&state, &inputs, &self.prepared),
        }
    }

    errors_of_the_model!();
}
