//! Factors of a mass matrix that is not positive definite.
//!
//! P M = L U with exchange of rows, in each lane as that lane wants it: what a lane gives is what it gives
//! alone. See Golub & Van Loan, *Matrix Computations*, 4th edition, 3.4; that rows are compared by their
//! entries in relation to their largest makes the choice independent of the units of the rows.

use nalgebra::{SMatrix, SVector};

use super::lane_select::{divisor, exchange_rows, greater, is_zero, number};
use crate::scalar::Scalar;

/// The factors of a matrix whose rows were exchanged.
pub(crate) struct Pivoted<S: Scalar, const N: usize> {
    /// Below the diagonal the unit lower factor L, above it U.
    pub(crate) factors: SMatrix<S, N, N>,
    /// The reciprocals of the diagonal of U; infinite where the matrix is singular.
    pub(crate) reciprocals: SVector<S, N>,
    /// With which row below it, or itself, each row was exchanged, one after the other.
    pub(crate) exchanges: SVector<S, N>,
}

impl<S: Scalar, const N: usize> Pivoted<S, N> {
    /// Factors `matrix`. A row that is zero at its turn stays as it is, and there is nothing to eliminate
    /// with it.
    pub(crate) fn new(matrix: SMatrix<S, N, N>) -> Self {
        let mut factors = matrix;
        let mut scales = SVector::<S, N>::from_fn(|i, _| {
            let entries = factors.row(i);
            entries.iter().fold(S::zero(), |most, x| most.max(x.abs()))
        });
        let mut reciprocals = SVector::zeros();
        let mut exchanges = SVector::zeros();
        for j in 0..N {
            let best = best_row(&factors, &scales, j);
            exchanges[j] = best;
            for i in j + 1..N {
                let wanted = is_zero(best - number(i));
                exchange_rows(&mut factors, j, i, wanted);
                exchange_rows(&mut scales, j, i, wanted);
            }
            let pivot = factors[(j, j)];
            reciprocals[j] = S::one() / pivot;
            let reciprocal = S::one() / divisor(pivot);
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
            exchanges,
        }
    }
}

/// The row from `j` on whose entry in column j is the largest in relation to the largest that it had.
fn best_row<S: Scalar, const N: usize>(
    factors: &SMatrix<S, N, N>,
    scales: &SVector<S, N>,
    j: usize,
) -> S {
    let weight = |i: usize| factors[(i, j)].abs() / divisor(scales[i]);
    let (mut best, mut greatest) = (number::<S>(j), weight(j));
    for i in j + 1..N {
        let weight = weight(i);
        let wanted = greater(weight, greatest);
        best += wanted * (number::<S>(i) - best);
        greatest = greatest.max(weight);
    }
    best
}

/// The solutions of M X = B from the factors.
pub(crate) fn solve<S: Scalar, const N: usize, const K: usize>(
    factors: &SMatrix<S, N, N>,
    reciprocals: &SVector<S, N>,
    exchanges: &SVector<S, N>,
    right: &SMatrix<S, N, K>,
) -> SMatrix<S, N, K> {
    let mut x = *right;
    for j in 0..N {
        for i in j + 1..N {
            exchange_rows(&mut x, j, i, is_zero(exchanges[j] - number(i)));
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

/// For each unknown the reciprocal of (|M⁻¹| |M|)ᵢᵢ, which lies between 0 and 1; 0 where M is singular to
/// working precision.
///
/// By so much at least grows a relative error of the entries of M, whatever the units of the coordinates are:
/// F. L. Bauer, *Numerische Mathematik* **5** (1963) 73–87; N. J. Higham, *Accuracy and Stability of Numerical
/// Algorithms*, 2nd edition, 7.2. An exchange of rows changes nothing in the product.
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
        // In place of zero a pivot so small that it says the same, but tells apart who is concerned.
        let small = epsilon * epsilon * divisor(scale);
        let pivot = factors[(i, i)];
        S::one() / (pivot + is_zero(pivot) * small)
    });
    let mut inverse = SMatrix::<S, N, N>::from_fn(|i, j| if i == j { S::one() } else { S::zero() });
    substitute(factors, &finite, &mut inverse);
    SVector::from_fn(|i, _| {
        let growth = (0..N).fold(S::zero(), |sum, k| {
            sum + (inverse[(i, k)] * product[(k, i)]).abs()
        });
        // The terms add up to 1 in a row that has not been replaced altogether.
        let regular = greater(growth, S::from_f64(0.5)) * greater(S::one(), epsilon * growth);
        regular / divisor(growth)
    })
}
