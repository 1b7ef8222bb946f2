//! The inverse of a mass matrix, lane by lane.
//!
//! Rows are exchanged as well as in a factorization, but by arithmetic: the lanes of one number may want
//! different exchanges, and of a [`Scalar`] it cannot be asked which.

use nalgebra::{SMatrix, SVector};

use crate::Scalar;

/// 1 where `left` is greater than `right`, in every lane that is so; 0 elsewhere.
#[inline]
pub(crate) fn greater<S: Scalar>(left: S, right: S) -> S {
    (left - right).signum().max(S::zero())
}

/// The number itself; 1 where it is zero, so that it can be divided by.
fn divisor<S: Scalar>(number: S) -> S {
    number + (S::one() - number.signum().abs())
}

/// An inverse, and how much was lost on the way to it.
pub(crate) struct Inverse<S: Scalar, const N: usize> {
    pub(crate) matrix: SMatrix<S, N, N>,
    /// For each row, the pivot in relation to the largest entry of the row.
    pub(crate) relative_pivots: SVector<S, N>,
}

/// A matrix on its way to diagonal form by operations on rows, and what they make of the unit matrix.
struct Elimination<S: Scalar, const N: usize> {
    matrix: SMatrix<S, N, N>,
    inverse: SMatrix<S, N, N>,
    /// Which row each was: a permutation, row by row.
    origins: SMatrix<S, N, N>,
    /// The largest entry that each row had.
    scale: SVector<S, N>,
}

impl<S: Scalar, const N: usize> Inverse<S, N> {
    /// By Gauss and Jordan, with exchange of rows in each lane that wants it.
    pub(crate) fn new(matrix: &SMatrix<S, N, N>) -> Self {
        let unit = SMatrix::from_fn(|i, j| if i == j { S::one() } else { S::zero() });
        let largest = |i| (0..N).fold(S::zero(), |most: S, j| most.max(matrix[(i, j)].abs()));
        let mut elimination = Elimination {
            matrix: *matrix,
            inverse: unit,
            origins: unit,
            scale: SVector::from_fn(|i, _| largest(i)),
        };
        let mut relative_pivots = SVector::zeros();
        for j in 0..N {
            elimination.choose_pivot(j);
            // A lane in which it is no number has nothing left.
            let left = elimination.weight(j, j).max(S::zero());
            for i in 0..N {
                relative_pivots[i] += elimination.origins[(j, i)] * left;
            }
            elimination.eliminate(j);
        }
        let Elimination {
            matrix: diagonal,
            inverse,
            ..
        } = elimination;
        Self {
            matrix: SMatrix::from_fn(|i, j| inverse[(i, j)] / diagonal[(i, i)]),
            relative_pivots,
        }
    }
}

impl<S: Scalar, const N: usize> Elimination<S, N> {
    /// The size of an entry in relation to what its row had.
    fn weight(&self, i: usize, j: usize) -> S {
        self.matrix[(i, j)].abs() / divisor(self.scale[i])
    }

    /// Brings the row of greatest weight in column j to row j, in each lane.
    fn choose_pivot(&mut self, j: usize) {
        for i in j + 1..N {
            let wanted = greater(self.weight(i, j), self.weight(j, j));
            let Self {
                matrix,
                inverse,
                origins,
                scale,
            } = self;
            for matrix in [matrix, inverse, origins] {
                for k in 0..N {
                    let (upper, lower) = exchanged(wanted, matrix[(j, k)], matrix[(i, k)]);
                    matrix[(j, k)] = upper;
                    matrix[(i, k)] = lower;
                }
            }
            let (upper, lower) = exchanged(wanted, scale[j], scale[i]);
            scale[j] = upper;
            scale[i] = lower;
        }
    }

    /// Subtracts multiples of row j from the others. In a lane where there is no pivot the rows below
    /// have nothing either, and keep what they have.
    fn eliminate(&mut self, j: usize) {
        let pivot = divisor(self.matrix[(j, j)]);
        for i in (0..N).filter(|i| *i != j) {
            let multiplier = self.matrix[(i, j)] / pivot;
            for matrix in [&mut self.matrix, &mut self.inverse] {
                for k in 0..N {
                    let change = multiplier * matrix[(j, k)];
                    matrix[(i, k)] -= change;
                }
            }
        }
    }
}

/// The two numbers, the other way round where `wanted` is 1.
fn exchanged<S: Scalar>(wanted: S, upper: S, lower: S) -> (S, S) {
    let kept = S::one() - wanted;
    (kept * upper + wanted * lower, kept * lower + wanted * upper)
}
