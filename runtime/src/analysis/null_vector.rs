//! A null vector of a singular complex matrix, by inverse iteration.
//!
//! J. H. Wilkinson, *The Algebraic Eigenvalue Problem*, 1965, chapter 9.

use nalgebra::{Complex, SMatrix, SVector};

use super::spectrum::modulus;
use crate::limits::analysis::INVERSE_ITERATIONS;

type C = Complex<f64>;

/// Returns a unit vector that a singular matrix takes nearly to zero, orthogonal to other vectors.
pub(super) fn null_vector<const N: usize>(
    matrix: &SMatrix<C, N, N>,
    others: impl Iterator<Item = SVector<C, N>> + Clone,
) -> SVector<C, N> {
    let factorization = Factorization::new(matrix);
    // The start has no pattern, so that hardly any of its components is near zero.
    let mut x = SVector::<C, N>::from_fn(|i, _| {
        #[allow(clippy::cast_precision_loss)] // An index.
        let phase = 1.0 + 2.4 * i as f64;
        C::new(libm::sin(phase) + 1.5, libm::cos(phase))
    });
    for _ in 0..INVERSE_ITERATIONS {
        orthogonalize(&mut x, others.clone());
        x = factorization.solve(&x);
    }
    orthogonalize(&mut x, others);
    x
}

/// The factorization PA = LU with column pivoting; a vanishing pivot is replaced by a number of the size of the
/// rounding errors.
struct Factorization<const N: usize> {
    /// L below the diagonal, without its unit diagonal, and U.
    factors: SMatrix<C, N, N>,
    /// The row of A for each row of PA.
    rows: [usize; N],
}

impl<const N: usize> Factorization<N> {
    fn new(matrix: &SMatrix<C, N, N>) -> Self {
        let size = matrix.iter().fold(0.0, |most, x| modulus(*x).max(most));
        // For a zero matrix, every vector is a null vector.
        let least = if size > 1e-100 {
            f64::EPSILON * size
        } else {
            1.0
        };
        let mut factors = *matrix;
        let mut rows: [usize; N] = core::array::from_fn(|i| i);
        for j in 0..N {
            let pivot = (j..N).fold(j, |best, i| {
                if modulus(factors[(i, j)]) > modulus(factors[(best, j)]) {
                    i
                } else {
                    best
                }
            });
            factors.swap_rows(j, pivot);
            rows.swap(j, pivot);
            if modulus(factors[(j, j)]) <= least {
                factors[(j, j)] = C::new(least, 0.0);
            }
            for i in j + 1..N {
                let multiplier = factors[(i, j)] / factors[(j, j)];
                factors[(i, j)] = multiplier;
                for k in j + 1..N {
                    let change = multiplier * factors[(j, k)];
                    factors[(i, k)] -= change;
                }
            }
        }
        Self { factors, rows }
    }

    /// Returns A⁻¹ times a vector.
    fn solve(&self, right: &SVector<C, N>) -> SVector<C, N> {
        let mut x: SVector<C, N> = SVector::from_fn(|i, _| right[self.rows[i]]);
        for i in 0..N {
            for k in 0..i {
                let change = self.factors[(i, k)] * x[k];
                x[i] -= change;
            }
        }
        for i in (0..N).rev() {
            for k in i + 1..N {
                let change = self.factors[(i, k)] * x[k];
                x[i] -= change;
            }
            x[i] /= self.factors[(i, i)];
        }
        x
    }
}

/// Removes the components of a vector along unit vectors, and normalizes it.
fn orthogonalize<const N: usize>(
    x: &mut SVector<C, N>,
    others: impl Iterator<Item = SVector<C, N>>,
) {
    scale(x);
    for other in others {
        let products = other.iter().zip(x.iter());
        let component: C = products.map(|(y, x)| y.conj() * x).sum();
        *x -= other * component;
    }
    scale(x);
}

/// Normalizes a vector to length 1, without overflow.
fn scale<const N: usize>(x: &mut SVector<C, N>) {
    let most = x.iter().fold(0.0, |most, x| modulus(*x).max(most));
    if most > 0.0 && most.is_finite() {
        *x /= C::new(most, 0.0);
        let squares: f64 = x.iter().map(C::norm_sqr).sum();
        *x /= C::new(libm::sqrt(squares), 0.0);
    }
}
