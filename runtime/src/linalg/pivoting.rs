//! LU factorization with scaled partial pivoting, for a mass matrix that is not positive definite.
//!
//! P M = L U, with separate row interchanges for each SIMD lane, so that the result of a lane does not depend on the
//! others. Golub & Van Loan, *Matrix Computations*, 4th edition (2013), 3.4. In the comparison, rows are scaled as the
//! symmetric matrix is equilibrated by rows and columns at once (D. Ruiz, *A scaling algorithm to equilibrate both rows and
//! columns norms in matrices*, RAL-TR-2001-034 (2001)), so that units matter little for the choice of the pivot.

use nalgebra::{SMatrix, SVector};

use super::lane_select::{from_index, greater, is_zero, one_if_zero, square_root, swap_rows};
use crate::limits::EQUILIBRATION_SWEEPS;
use crate::scalar::Scalar;

/// The factorization P M = L U.
pub(crate) struct PivotedLu<S: Scalar, const N: usize> {
    /// The unit lower triangular factor L below the diagonal; U above it.
    pub(crate) factors: SMatrix<S, N, N>,
    /// The reciprocals of the diagonal of U; infinite where the matrix is singular.
    pub(crate) reciprocals: SVector<S, N>,
    /// The index of the row with which each row is interchanged, in order: a row below it, or the row itself.
    pub(crate) interchanges: SVector<S, N>,
}

impl<S: Scalar, const N: usize> PivotedLu<S, N> {
    /// Factors `matrix`. Where the pivot column is zero, nothing is eliminated.
    pub(crate) fn new(matrix: SMatrix<S, N, N>) -> Self {
        let mut factors = matrix;
        let mut scales = equilibration(&matrix);
        let mut reciprocals = SVector::zeros();
        let mut interchanges = SVector::zeros();
        for j in 0..N {
            let row = pivot_row(&factors, &scales, j);
            interchanges[j] = row;
            for i in j + 1..N {
                let mask = is_zero(row - from_index(i));
                swap_rows(&mut factors, j, i, mask);
                swap_rows(&mut scales, j, i, mask);
            }
            let pivot = factors[(j, j)];
            reciprocals[j] = S::one() / pivot;
            let reciprocal = S::one() / one_if_zero(pivot);
            for i in j + 1..N {
                let multiplier = factors[(i, j)] * reciprocal;
                factors[(i, j)] = multiplier;
                for k in j + 1..N {
                    let change = multiplier * factors[(j, k)];
                    factors[(i, k)] -= change;
                }
            }
        }
        Self {
            factors,
            reciprocals,
            interchanges,
        }
    }

    /// Returns A⁻¹ B.
    pub(crate) fn solve<const K: usize>(&self, right: &SMatrix<S, N, K>) -> SMatrix<S, N, K> {
        solve(&self.factors, &self.reciprocals, &self.interchanges, right)
    }
}

/// Returns the scales dᵢ with which the largest entry of each row of dᵢ Mᵢⱼ dⱼ, for a symmetric M, is about 1; any for a row of zeros.
fn equilibration<S: Scalar, const N: usize>(matrix: &SMatrix<S, N, N>) -> SVector<S, N> {
    let mut scales = SVector::<S, N>::from_element(S::one());
    for _ in 0..EQUILIBRATION_SWEEPS {
        let largest = SVector::<S, N>::from_fn(|i, _| {
            let entries = matrix.row(i);
            let entries = entries.iter().zip(&scales);
            entries.fold(S::zero(), |most, (x, scale)| most.max((*x * *scale).abs()))
        });
        for (scale, largest) in scales.iter_mut().zip(&largest) {
            *scale /= square_root(one_if_zero(*largest * *scale));
        }
    }
    scales
}

/// Returns the index of the pivot row: the row from j on with the largest scaled entry in column j.
fn pivot_row<S: Scalar, const N: usize>(
    factors: &SMatrix<S, N, N>,
    scales: &SVector<S, N>,
    j: usize,
) -> S {
    let weight = |i: usize| factors[(i, j)].abs() * scales[i];
    let (mut row, mut largest) = (from_index::<S>(j), weight(j));
    for i in j + 1..N {
        let weight = weight(i);
        let mask = greater(weight, largest);
        row += mask * (from_index::<S>(i) - row);
        largest = largest.max(weight);
    }
    row
}

/// Returns the solution of M X = B, given the factors.
pub(super) fn solve<S: Scalar, const N: usize, const K: usize>(
    factors: &SMatrix<S, N, N>,
    reciprocals: &SVector<S, N>,
    interchanges: &SVector<S, N>,
    right: &SMatrix<S, N, K>,
) -> SMatrix<S, N, K> {
    let mut x = *right;
    for j in 0..N {
        for i in j + 1..N {
            swap_rows(&mut x, j, i, is_zero(interchanges[j] - from_index(i)));
        }
    }
    substitute(factors, reciprocals, &mut x);
    x
}

/// Solves L U X = B in place.
fn substitute<S: Scalar, const N: usize, const K: usize>(
    factors: &SMatrix<S, N, N>,
    reciprocals: &SVector<S, N>,
    x: &mut SMatrix<S, N, K>,
) {
    for column in 0..K {
        for i in 0..N {
            for k in 0..i {
                let change = factors[(i, k)] * x[(k, column)];
                x[(i, column)] -= change;
            }
        }
        for i in (0..N).rev() {
            for k in i + 1..N {
                let change = factors[(i, k)] * x[(k, column)];
                x[(i, column)] -= change;
            }
            x[(i, column)] *= reciprocals[i];
        }
    }
}

/// Returns for each unknown the reciprocal of (|M⁻¹| |M|)ᵢᵢ, which is between 0 and 1; 0 where M is singular to working
/// precision.
///
/// (|M⁻¹| |M|)ᵢᵢ is a lower bound for the amplification of relative errors of the entries of M, whatever the units of
/// the coordinates: F. L. Bauer, *Optimally scaled matrices*, Numer. Math. **5** (1963) 73–87; N. J. Higham, *Accuracy
/// and Stability of Numerical Algorithms*, 2nd edition (2002), 7.2. The product does not depend on row interchanges.
pub(crate) fn reciprocal_conditions<S: Scalar, const N: usize>(
    factors: &SMatrix<S, N, N>,
) -> SVector<S, N> {
    let product = SMatrix::<S, N, N>::from_fn(|i, j| {
        let below =
            (0..i.min(j + 1)).fold(S::zero(), |sum, k| sum + factors[(i, k)] * factors[(k, j)]);
        if i <= j {
            below + factors[(i, j)]
        } else {
            below
        }
    });
    let epsilon = S::from_f64(S::machine_epsilon());
    let finite = SVector::from_fn(|i, _| {
        let row = product.row(i);
        let scale = row.iter().fold(S::zero(), |most, x| most.max(x.abs()));
        // A tiny pivot replaces zero, so that the singular unknowns can be identified.
        let small = epsilon * epsilon * one_if_zero(scale);
        let pivot = factors[(i, i)];
        S::one() / (pivot + is_zero(pivot) * small)
    });
    let mut inverse = SMatrix::<S, N, N>::from_fn(|i, j| if i == j { S::one() } else { S::zero() });
    substitute(factors, &finite, &mut inverse);
    SVector::from_fn(|i, _| {
        let growth = (0..N).fold(S::zero(), |sum, k| {
            sum + (inverse[(i, k)] * product[(k, i)]).abs()
        });
        // In exact arithmetic the sum is at least 1; a sum below ½ means that the row consists of rounding errors.
        let regular = greater(growth, S::from_f64(0.5)) * greater(S::one(), epsilon * growth);
        regular / one_if_zero(growth)
    })
}
