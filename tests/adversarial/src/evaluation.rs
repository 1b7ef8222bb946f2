//! Everything that a model evaluates, by the names that the data have for it.

use lagrangian::{Energies, Inputs, Lagrangian};
use nalgebra::{SMatrix, SVector};

use crate::At;

/// A quantity and its entries, row by row.
pub type Found = (&'static str, Vec<f64>);

/// The function that evaluates a model.
pub type Evaluate = fn(&At) -> Vec<Found>;

/// What every model has.
#[must_use]
pub fn motion<M: Lagrangian<N>, const N: usize>(model: &M, at: &At) -> Vec<Found> {
    let state = at.state::<N>();
    let linearization = model.linearize(&state);
    let prepared = model.prepare();
    let trial = SVector::<f64, N>::from(at.trial::<N>());
    vec![
        ("L", vec![model.lagrangian(&state)]),
        ("h", vec![model.energy(&state)]),
        ("p", rows(&model.momenta(&state))),
        ("M", rows(&model.mass_matrix(&state))),
        ("f", rows(&model.forcing(&state))),
        ("Q", rows(&model.generalized_forces(&state))),
        ("qdd", rows(&model.accelerations(&state))),
        (
            "qdd",
            rows(&model.accelerations_prepared(&state, &prepared)),
        ),
        ("inverse", rows(&model.inverse_dynamics(&state, &trial))),
        ("dqdd_dq", rows(&linearization.position)),
        ("dqdd_dqd", rows(&linearization.velocity)),
        ("dqdd_dt", rows(&linearization.time)),
    ]
}

/// What a model has that is declared by its energies.
#[must_use]
pub fn energies<M: Energies<N>, const N: usize>(model: &M, at: &At) -> Vec<Found> {
    let state = at.state::<N>();
    vec![
        ("T", vec![model.kinetic_energy(&state)]),
        ("V", vec![model.potential_energy(&state)]),
    ]
}

/// What a model with inputs has besides.
#[must_use]
pub fn driven<M: Inputs<N, U>, const N: usize, const U: usize>(model: &M, at: &At) -> Vec<Found> {
    let jacobian = model.input_jacobian(&at.state::<N>());
    vec![("dqdd_du", rows(&jacobian))]
}

/// The entries of a matrix row by row.
#[must_use]
pub fn rows<const R: usize, const C: usize>(matrix: &SMatrix<f64, R, C>) -> Vec<f64> {
    matrix.transpose().as_slice().to_vec()
}
