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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::assert_close;

    #[test]
    fn matrices_are_written_row_by_row() {
        let matrix = SMatrix::<f64, 2, 3>::from_row_slice(&[1.0, 2.0, 3.0, 4.0, 5.0, 6.0]);
        assert_close(
            "a matrix",
            &rows(&matrix),
            &[1.0, 2.0, 3.0, 4.0, 5.0, 6.0],
            0.0,
        );
    }
}
