//! Some of the variables of a system, in an order.

use nalgebra::SMatrix;

use crate::scalar::Scalar;

/// Some of N variables.
#[derive(Clone, Copy)]
pub(super) struct Members<const N: usize> {
    indices: [usize; N],
    count: usize,
}

impl<const N: usize> core::ops::Deref for Members<N> {
    type Target = [usize];

    fn deref(&self) -> &[usize] {
        &self.indices[..self.count]
    }
}

impl<const N: usize> Members<N> {
    /// Collects the variables of different indices.
    pub(super) fn of(indices: impl Iterator<Item = usize>) -> Self {
        let mut members = Self {
            indices: [0; N],
            count: 0,
        };
        for (entry, index) in members.indices.iter_mut().zip(indices) {
            *entry = index;
            members.count += 1;
        }
        members
    }

    /// Returns the rows and columns of the members as the first ones of a matrix that is zero otherwise.
    pub(super) fn block<S: Scalar>(&self, matrix: &SMatrix<S, N, N>) -> SMatrix<S, N, N> {
        SMatrix::from_fn(|i, j| match (self.get(i), self.get(j)) {
            (Some(row), Some(column)) => matrix[(*row, *column)],
            _ => S::zero(),
        })
    }
}
