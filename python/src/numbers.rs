//! Vectors and matrices as lists of numbers.

use lagrangian::nalgebra::{Dim, Matrix, RawStorage, SVector};

/// A vector of the first components. Components that are missing are NaN.
pub(crate) fn vector<const N: usize>(components: &[f64]) -> SVector<f64, N> {
    SVector::from_fn(|i, _| components.get(i).copied().unwrap_or(f64::NAN))
}

/// Appends the elements of a matrix, row by row.
pub(crate) fn rows<R: Dim, C: Dim>(
    matrix: &Matrix<f64, R, C, impl RawStorage<f64, R, C>>,
    numbers: &mut Vec<f64>,
) {
    for row in matrix.row_iter() {
        numbers.extend(row.iter());
    }
}
