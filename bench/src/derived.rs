//! Our side: a model of the derive.

use std::hint::black_box;

use lagrangian::{EquationsOfMotion, Lagrangian, State};
use nalgebra::SVector;

use crate::evaluation::Evaluation;

/// A model and the function that is called, both hidden from the optimizer.
pub(crate) struct Derived<'a, M: Lagrangian<N>, const N: usize> {
    equations: EquationsOfMotion<&'a M, f64, N>,
    accelerations: Accelerations<'a, M, N>,
}

type Accelerations<'a, M, const N: usize> =
    fn(&EquationsOfMotion<&'a M, f64, N>, &State<f64, N>, &mut SVector<f64, N>);

impl<'a, M: Lagrangian<N>, const N: usize> Derived<'a, M, N> {
    pub(crate) fn new(model: &'a M) -> Self {
        Self {
            equations: black_box(black_box(model).dynamics()),
            accelerations: black_box(accelerations),
        }
    }
}

/// The method that integrators call, behind the boundary that the peers have too. What depends on the
/// parameters alone has been computed once, as an integration does; the peers have it as constants.
#[inline(never)]
fn accelerations<M: Lagrangian<N>, const N: usize>(
    equations: &EquationsOfMotion<&M, f64, N>,
    state: &State<f64, N>,
    accelerations: &mut SVector<f64, N>,
) {
    *accelerations = equations.accelerations(state);
}

impl<M: Lagrangian<N>, const N: usize> Evaluation<N> for Derived<'_, M, N> {
    type State = State<f64, N>;

    fn state(row: &[f64]) -> Self::State {
        let (q, v) = row.split_at(N);
        State::new(
            0.0,
            SVector::from_column_slice(q),
            SVector::from_column_slice(v),
        )
    }

    #[inline]
    fn moved(state: &Self::State, by: &SVector<f64, N>) -> Self::State {
        State::new(state.t, state.q + by, state.v + by)
    }

    #[inline]
    fn evaluate(&self, state: &Self::State, accelerations: &mut SVector<f64, N>) {
        (self.accelerations)(&self.equations, state, accelerations);
    }
}

/// Inverse dynamics of a model, hidden likewise.
pub(crate) struct InverseDynamics<'a, M: Lagrangian<N>, const N: usize> {
    equations: EquationsOfMotion<&'a M, f64, N>,
    forces: Forces<'a, M, N>,
}

type Forces<'a, M, const N: usize> =
    fn(&EquationsOfMotion<&'a M, f64, N>, &State<f64, N>, &SVector<f64, N>, &mut SVector<f64, N>);

impl<'a, M: Lagrangian<N>, const N: usize> InverseDynamics<'a, M, N> {
    pub(crate) fn new(model: &'a M) -> Self {
        Self {
            equations: black_box(black_box(model).dynamics()),
            forces: black_box(forces),
        }
    }
}

#[inline(never)]
fn forces<M: Lagrangian<N>, const N: usize>(
    equations: &EquationsOfMotion<&M, f64, N>,
    state: &State<f64, N>,
    accelerations: &SVector<f64, N>,
    forces: &mut SVector<f64, N>,
) {
    *forces = equations.inverse_dynamics(state, accelerations);
}

impl<M: Lagrangian<N>, const N: usize> Evaluation<N> for InverseDynamics<'_, M, N> {
    type State = (State<f64, N>, SVector<f64, N>);

    fn state(row: &[f64]) -> Self::State {
        let (phase, accelerations) = row.split_at(2 * N);
        let state = Derived::<M, N>::state(phase);
        (state, SVector::from_column_slice(accelerations))
    }

    #[inline]
    fn moved((state, accelerations): &Self::State, by: &SVector<f64, N>) -> Self::State {
        (Derived::<M, N>::moved(state, by), accelerations + by)
    }

    #[inline]
    fn evaluate(&self, (state, accelerations): &Self::State, forces: &mut SVector<f64, N>) {
        (self.forces)(&self.equations, state, accelerations, forces);
    }
}
