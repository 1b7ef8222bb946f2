//! Vectors and matrices from arrays, by functions: emitted code may stand where no trait is in scope.

use nalgebra::{SMatrix, SVector, Scalar};

/// The vector of these components.
#[inline]
pub fn vector<S: Scalar, const N: usize>(components: [S; N]) -> SVector<S, N> {
    SVector::from(components)
}

/// The matrix of these columns.
#[inline]
pub fn matrix<S: Scalar, const R: usize, const C: usize>(columns: [[S; R]; C]) -> SMatrix<S, R, C> {
    SMatrix::from(columns)
}
