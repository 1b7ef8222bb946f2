//! Matrices of models with many coordinates, column by column, so that the code does not grow with the matrices.
//!
//! The columns of M are the momenta at unit velocities. Method 1 of M. W. Walker and D. E. Orin, Efficient dynamic
//! computer simulation of robotic mechanisms, J. Dyn. Sys. Meas. Control **104** (1982) 205–211 takes the generalized
//! forces at unit accelerations instead, but momenta cost less. The derivatives of q̈ solve M δq̈ = −δ(M q̈ − f) at
//! fixed q̈ (J. Carpentier and N. Mansard, Analytical derivatives of rigid body dynamics algorithms, RSS 2018), with
//! the inverse dynamics evaluated on [dual numbers](Dual).

use nalgebra::{SMatrix, SVector};

use super::linearization::Linearization;
use super::state::State;
use crate::linalg::Factorization;
use crate::scalar::{Dual, Scalar};

/// Returns M at a state, given the momenta, which are of first degree in the velocities.
pub fn mass_matrix_by_columns<S: Scalar, const N: usize>(
    state: &State<S, N>,
    momenta: impl Fn(&State<S, N>) -> SVector<S, N>,
) -> SMatrix<S, N, N> {
    let mut state = State::new(state.t, state.q, SVector::zeros());
    let at_rest = momenta(&state);
    let mut mass = SMatrix::zeros();
    for j in 0..N {
        state.v[j] = S::one();
        let column = momenta(&state) - at_rest;
        state.v[j] = S::zero();
        for i in j..N {
            mass[(i, j)] = column[i];
            mass[(j, i)] = column[i];
        }
    }
    mass
}

/// Returns the derivatives of q̈ by q, q̇ and t, given M q̈ − f on dual numbers and the factors of M.
pub fn linearization_by_columns<S: Scalar, const N: usize, const D: usize>(
    state: &State<S, N>,
    accelerations: &SVector<S, N>,
    factors: &Factorization<S, N>,
    inverse_dynamics: impl Fn(&State<Dual<S, D>, N>, &SVector<Dual<S, D>, N>) -> SVector<Dual<S, D>, N>,
) -> Linearization<S, N> {
    let accelerations = constants(accelerations);
    let mut found = Linearization {
        position: SMatrix::zeros(),
        velocity: SMatrix::zeros(),
        time: SVector::zeros(),
    };
    for first in (0..=2 * N).step_by(D) {
        let variable = |value, number: usize| Dual::variable(value, number.wrapping_sub(first));
        let state = State::new(
            variable(state.t, 2 * N),
            SVector::from_fn(|i, _| variable(state.q[i], i)),
            SVector::from_fn(|i, _| variable(state.v[i], N + i)),
        );
        let residuals = inverse_dynamics(&state, &accelerations);
        for (i, residual) in residuals.iter().enumerate() {
            for (number, slope) in (first..=2 * N).zip(residual.derivative) {
                match number {
                    _ if number < N => found.position[(i, number)] = -slope,
                    _ if number < 2 * N => found.velocity[(i, number - N)] = -slope,
                    _ => found.time[i] = -slope,
                }
            }
        }
    }
    Linearization {
        position: factors.solve(&found.position),
        velocity: factors.solve(&found.velocity),
        time: factors.solve(&found.time),
    }
}

/// Returns the derivatives of q̈ by the inputs, given M q̈ − f on dual numbers and the factors of M.
pub fn input_jacobian_by_columns<S: Scalar, const N: usize, const U: usize, const D: usize>(
    inputs: &SVector<S, U>,
    factors: &Factorization<S, N>,
    inverse_dynamics: impl Fn(&SVector<Dual<S, D>, U>) -> SVector<Dual<S, D>, N>,
) -> SMatrix<S, N, U> {
    let mut found = SMatrix::zeros();
    for first in (0..U).step_by(D) {
        let inputs = SVector::from_fn(|j, _| Dual::variable(inputs[j], j.wrapping_sub(first)));
        let residuals = inverse_dynamics(&inputs);
        for (i, residual) in residuals.iter().enumerate() {
            for (number, slope) in (first..U).zip(residual.derivative) {
                found[(i, number)] = -slope;
            }
        }
    }
    factors.solve(&found)
}

/// Returns a constant vector on dual numbers.
pub fn constants<S: Scalar, const K: usize, const D: usize>(
    values: &SVector<S, K>,
) -> SVector<Dual<S, D>, K> {
    values.map(Dual::constant)
}

/// Returns a constant state on dual numbers.
pub fn constant_state<S: Scalar, const N: usize, const D: usize>(
    state: &State<S, N>,
) -> State<Dual<S, D>, N> {
    State::new(
        Dual::constant(state.t),
        constants(&state.q),
        constants(&state.v),
    )
}
