//! The sizes of entries of vectors and matrices, and entries that are kept while the others are zero.

use nalgebra::SMatrix;

use crate::scalar::Scalar;

/// Returns the largest magnitude among numbers, in any lane; NaN does not count.
pub(crate) fn largest<'a, S: Scalar>(numbers: impl IntoIterator<Item = &'a S>) -> f64 {
    let sizes = numbers.into_iter().map(|x| x.abs().largest());
    sizes.fold(0.0, f64::max)
}

/// Returns the largest magnitude among numbers, in any lane, or NaN if one is NaN.
pub(crate) fn largest_or_nan<'a, S: Scalar>(numbers: impl IntoIterator<Item = &'a S>) -> f64 {
    let sizes = numbers.into_iter().map(|x| x.abs().largest());
    sizes.fold(0.0, |most, size| {
        if size > most || size.is_nan() {
            size
        } else {
            most
        }
    })
}

/// Returns the place of the first of the largest numbers, and the number; 0 and 0 if none is positive.
pub(crate) fn first_largest(numbers: impl IntoIterator<Item = f64>) -> (usize, f64) {
    let numbers = numbers.into_iter().enumerate();
    numbers.fold(
        (0, 0.0),
        |most, (i, number)| {
            if number > most.1 { (i, number) } else { most }
        },
    )
}

/// Returns a matrix with zeros in place of the entries that are not kept.
pub(crate) fn kept<S: Scalar, const R: usize, const C: usize>(
    matrix: &SMatrix<S, R, C>,
    is_kept: impl Fn(usize, usize) -> bool,
) -> SMatrix<S, R, C> {
    SMatrix::from_fn(|i, j| {
        if is_kept(i, j) {
            matrix[(i, j)]
        } else {
            S::zero()
        }
    })
}
