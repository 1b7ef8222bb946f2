//! What the build script implements for the models it writes.

use lagrangian::State;
use nalgebra::SMatrix;

/// A model that can be made from the values of its parameters and inputs.
pub trait Parametrized: Sized {
    /// The model whose fields have these values.
    fn with(value: &dyn Fn(&str) -> f64) -> Self;
}

/// A model whose inputs are functions of time.
pub trait Law<const U: usize> {
    /// The inputs at a time.
    fn inputs_at(&self, t: f64) -> [f64; U];
}

/// A model for which the data list more than the usual quantities.
pub trait Observed<const N: usize> {
    /// Those quantities, by the names of the data: outputs of the declaration.
    fn observed(&self, state: &State<f64, N>) -> Vec<(&'static str, f64)> {
        let _ = state;
        Vec::new()
    }
}

/// The entries of a matrix row by row, as the data have them.
#[must_use]
pub fn rows<const N: usize, const K: usize>(matrix: &SMatrix<f64, N, K>) -> Vec<f64> {
    matrix.transpose().as_slice().to_vec()
}
