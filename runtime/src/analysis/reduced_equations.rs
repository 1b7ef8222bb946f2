//! The linear equations of small oscillations, reduced to the coordinates that remain.

use nalgebra::{SMatrix, SVector};

use super::balance::{HeldInputs, Point, momentum_gradients};
use crate::integrate::SingleNumber;
use crate::linalg::{Factorization, kept};
use crate::model::{Lagrangian, Linearization, State, StateJacobian};
use crate::scalar::Scalar;

/// The role of a coordinate in small oscillations.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Part {
    /// It oscillates.
    Oscillating,
    /// It is ignorable, but its momentum is not constant: only its velocity is a variable.
    Moving,
    /// It is ignorable, and its momentum is constant.
    Eliminated,
}

/// The linear equations after elimination.
#[derive(Clone, Copy, Debug)]
pub(super) struct Reduced<S: Scalar, const N: usize> {
    pub(super) mass: SMatrix<S, N, N>,
    pub(super) position: SMatrix<S, N, N>,
    pub(super) velocity: SMatrix<S, N, N>,
    pub(super) velocity_terms: SMatrix<S, N, N>,
    pub(super) eliminated: [SMatrix<S, N, N>; 2],
}

impl<S: SingleNumber, const N: usize> Reduced<S, N> {
    /// Evaluates the reduced linear equations at a state.
    pub(super) fn at<M>(model: &M, state: &State<S, N>, parts: &[Part; N]) -> Self
    where
        M: Lagrangian<N, S, Model: StateJacobian<N, S>> + ?Sized,
    {
        let mass = model.mass_matrix(state);
        let gradients = momentum_gradients(&HeldInputs(model), &under_held_inputs(state));
        Self::of(parts, &mass, &gradients, &model.linearize(state))
    }

    /// Evaluates them from the mass matrix, ∂p/∂q and the linearized accelerations.
    pub(super) fn of(
        parts: &[Part; N],
        mass: &SMatrix<S, N, N>,
        gradients: &SMatrix<S, N, N>,
        slopes: &Linearization<S, N>,
    ) -> Self {
        let (position, velocity) = (slopes.position, slopes.velocity);
        let eliminated = eliminated_velocities(parts, mass, gradients);
        let [by_position, by_velocity] = &eliminated;
        let is_left = |i: usize| parts[i] != Part::Eliminated;
        let is_coordinate = |i: usize| parts[i] == Part::Oscillating;
        let keep = |matrix: SMatrix<S, N, N>, column: &dyn Fn(usize) -> bool| {
            kept(&matrix, |i, j| is_left(i) && column(j))
        };
        let transposed = by_velocity.transpose();
        let [mass_terms, velocity_terms, chain] =
            [mass, &velocity, by_velocity].map(|matrix| matrix.map(S::abs));
        Self {
            velocity_terms: keep(
                chain.transpose() * mass_terms * velocity_terms * chain,
                &is_left,
            ),
            mass: keep(transposed * mass * by_velocity, &is_left),
            position: keep(position + velocity * by_position, &is_coordinate),
            velocity: keep(velocity * by_velocity, &is_left),
            eliminated,
        }
    }
}

/// Returns the point of a state under the inputs of the model.
pub(super) fn under_held_inputs<S: Scalar, const N: usize>(state: &State<S, N>) -> Point<S, N, 0> {
    Point {
        state: *state,
        inputs: SVector::zeros(),
        independent: [true; N],
    }
}

/// Returns the velocities of all coordinates as linear functions of the remaining coordinates and velocities;
/// eliminated velocities follow from the constant momenta.
fn eliminated_velocities<S: SingleNumber, const N: usize>(
    parts: &[Part; N],
    mass: &SMatrix<S, N, N>,
    gradients: &SMatrix<S, N, N>,
) -> [SMatrix<S, N, N>; 2] {
    let is_eliminated = |i: usize| parts[i] == Part::Eliminated;
    let unit = |i: usize, j: usize| if i == j { S::one() } else { S::zero() };
    let block = SMatrix::from_fn(|i, j| {
        if is_eliminated(i) && is_eliminated(j) {
            mass[(i, j)]
        } else {
            unit(i, j)
        }
    });
    let factors = Factorization::new(block);
    let by_position = kept(&-gradients, |i, j| {
        is_eliminated(i) && parts[j] == Part::Oscillating
    });
    let by_velocity = SMatrix::from_fn(|i, j| match (is_eliminated(i), is_eliminated(j)) {
        (true, false) => -mass[(i, j)],
        (false, false) => unit(i, j),
        (_, true) => S::zero(),
    });
    [factors.solve(&by_position), factors.solve(&by_velocity)]
}
