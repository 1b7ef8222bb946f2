//! Functions that make vectors and matrices from arrays, for emitted code in which no trait may be in scope.

use nalgebra::{SMatrix, SVector, Scalar};

/// Returns the vector with these components.
#[inline]
pub fn vector<S: Scalar, const N: usize>(components: [S; N]) -> SVector<S, N> {
    SVector::from(components)
}

/// Returns the matrix with these columns.
#[inline]
pub fn matrix<S: Scalar, const R: usize, const C: usize>(columns: [[S; R]; C]) -> SMatrix<S, R, C> {
    SMatrix::from(columns)
}
