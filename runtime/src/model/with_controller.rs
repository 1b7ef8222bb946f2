//! Dynamic feedback: a controller with states of its own.

use nalgebra::SVector;

use super::augmented_phase::AugmentedPhase;
use super::common_dynamics::{allowed_error, component_name, singularities_of_the_model};
use super::inputs::Inputs;
use super::phase::Phase;
use super::state::State;
use crate::integrate::{ComponentName, Dynamics};
use crate::linalg::{ErrorTolerance, IntoVector};
use crate::scalar::Scalar;

/// A system under the dynamic feedback (u, ż) = law(t, q, q̇, z) of a controller with `K` states z; made by
/// [`Plant::with_controller`](crate::Plant::with_controller).
///
/// Its state is the augmented one (q, q̇, z), which moves by (q̇, q̈(q, q̇, t, u), ż). The error scale
/// of zₖ is |zₖ|. The quantities that depend on parameters only are computed when it is made.
#[derive(Debug)]
pub struct WithController<'a, M, C, S, const N: usize, const U: usize, const K: usize>
where
    M: Inputs<N, U, S> + ?Sized,
    S: Scalar,
{
    pub(super) model: &'a M,
    pub(super) prepared: M::Prepared,
    law: C,
}

impl<M, C, S, const N: usize, const U: usize, const K: usize> Clone
    for WithController<'_, M, C, S, N, U, K>
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

impl<'a, M, C, S, const N: usize, const U: usize, const K: usize>
    WithController<'a, M, C, S, N, U, K>
where
    M: Inputs<N, U, S> + ?Sized,
    S: Scalar,
{
    /// The model under a controller on any scalar on which the model is evaluated, such as
    /// `|state: &State<f32, 2>, z: &SVector<f32, 1>| …`.
    pub fn new<R, Z>(model: &'a M, law: C) -> Self
    where
        C: Fn(&State<S, N>, &SVector<S, K>) -> (R, Z),
        R: IntoVector<S, U>,
        Z: IntoVector<S, K>,
    {
        Self {
            model,
            prepared: model.prepare(),
            law,
        }
    }

    /// The inputs u that the controller sets at a state of the system and its own states z.
    #[inline]
    pub fn inputs<R, Z>(&self, state: &State<S, N>, controller: &SVector<S, K>) -> SVector<S, U>
    where
        C: Fn(&State<S, N>, &SVector<S, K>) -> (R, Z),
        R: IntoVector<S, U>,
    {
        (self.law)(state, controller).0.into_vector()
    }
}

impl<M, C, R, Z, S, const N: usize, const U: usize, const K: usize> Dynamics<S>
    for WithController<'_, M, C, S, N, U, K>
where
    M: Inputs<N, U, S> + ?Sized,
    C: Fn(&State<S, N>, &SVector<S, K>) -> (R, Z),
    R: IntoVector<S, U>,
    Z: IntoVector<S, K>,
    S: Scalar,
{
    type State = AugmentedPhase<S, N, K>;

    #[inline]
    fn derivative(&self, t: S, x: &Self::State) -> Self::State {
        let state = x.at(t);
        let (inputs, controller) = (self.law)(&state, &x.controller);
        AugmentedPhase {
            q: x.v,
            v: self
                .model
                .accelerations(&state, &inputs.into_vector(), &self.prepared),
            controller: controller.into_vector(),
        }
    }

    #[inline]
    fn allowed_error(&self, x: &Self::State, tolerance: &ErrorTolerance<S>) -> Self::State {
        let Phase { q, v } = allowed_error::<M, S, N>(&x.phase(), tolerance);
        let controller = x.controller.map(|z| tolerance.of_coordinate(z.abs()));
        AugmentedPhase { q, v, controller }
    }

    singularities_of_the_model!();

    fn component_name(&self, index: usize) -> ComponentName {
        match index.checked_sub(2 * N) {
            Some(own) => ComponentName::Controller(own),
            None => component_name::<M, N>(index),
        }
    }
}
