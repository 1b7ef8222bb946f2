//! Eigenvalues and eigenvectors of symmetric matrices, by the cyclic Jacobi method.
//!
//! G. H. Golub and C. F. Van Loan, *Matrix Computations*, 4th edition (2013), 8.5. Eigenvectors are orthogonal up to
//! rounding even if eigenvalues are equal.

use nalgebra::{SMatrix, SVector};

use crate::integrate::SingleNumber;
use crate::limits::analysis::JACOBI_SWEEPS;

/// Returns the eigenvalues of a symmetric matrix in ascending order, and its eigenvectors in the corresponding columns
/// of an orthogonal matrix. Only the leading block of some order is read; the rest of both results is zero.
pub(crate) fn symmetric_eigenvalues<S: SingleNumber, const N: usize>(
    matrix: &SMatrix<S, N, N>,
    order: usize,
) -> (SVector<S, N>, SMatrix<S, N, N>) {
    let mut a = *matrix;
    let mut vectors = SMatrix::from_fn(|i, j| {
        if i == j && i < order {
            S::one()
        } else {
            S::zero()
        }
    });
    for _ in 0..JACOBI_SWEEPS {
        let mut rotated = false;
        for p in 0..order {
            for q in p + 1..order {
                rotated |= rotate(&mut a, &mut vectors, [p, q], order);
            }
        }
        if !rotated {
            break;
        }
    }
    let mut values = SVector::from_fn(|i, _| if i < order { a[(i, i)] } else { S::zero() });
    sort(&mut values, &mut vectors, order);
    (values, vectors)
}

/// Makes the entry (p, q) zero, unless it is negligible.
fn rotate<S: SingleNumber, const N: usize>(
    a: &mut SMatrix<S, N, N>,
    vectors: &mut SMatrix<S, N, N>,
    [p, q]: [usize; 2],
    order: usize,
) -> bool {
    let entry = a[(p, q)];
    let scale = (a[(p, p)].abs() * a[(q, q)].abs()).sqrt().largest();
    let size = entry.abs().largest();
    let largest = a[(p, p)].abs().largest().max(a[(q, q)].abs().largest());
    let negligible = S::machine_epsilon() * scale.max(S::machine_epsilon() * largest);
    // NaN is left unchanged.
    if !(size > 0.0 && size > negligible) {
        return false;
    }
    let tau = (a[(q, q)] - a[(p, p)]) / (entry + entry);
    let root = (S::one() + tau * tau).sqrt();
    let tangent = if tau.largest() < 0.0 {
        S::one() / (tau - root)
    } else {
        S::one() / (tau + root)
    };
    let cosine = S::one() / (S::one() + tangent * tangent).sqrt();
    let sine = tangent * cosine;
    let turned = |[x, y]: [S; 2]| [cosine * x - sine * y, sine * x + cosine * y];
    for k in 0..order {
        [a[(k, p)], a[(k, q)]] = turned([a[(k, p)], a[(k, q)]]);
    }
    for k in 0..order {
        [a[(p, k)], a[(q, k)]] = turned([a[(p, k)], a[(q, k)]]);
    }
    a[(p, q)] = S::zero();
    a[(q, p)] = S::zero();
    for k in 0..order {
        [vectors[(k, p)], vectors[(k, q)]] = turned([vectors[(k, p)], vectors[(k, q)]]);
    }
    true
}

/// Sorts eigenvalues with their eigenvectors.
fn sort<S: SingleNumber, const N: usize>(
    values: &mut SVector<S, N>,
    vectors: &mut SMatrix<S, N, N>,
    order: usize,
) {
    for i in 0..order {
        let least = (i..order).fold(i, |least, j| {
            if (values[j] - values[least]).largest() < 0.0 {
                j
            } else {
                least
            }
        });
        values.swap_rows(i, least);
        vectors.swap_columns(i, least);
    }
}
