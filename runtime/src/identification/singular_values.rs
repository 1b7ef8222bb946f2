//! Singular values by one-sided Jacobi rotations (Hestenes, Inversion of matrices by biorthogonalization, 1958; Golub
//! and Van Loan, Matrix Computations, 4th edition 2013, section 8.6.3), which determine small ones with high relative
//! accuracy (Demmel and Veselić, Jacobi's method is more accurate than QR, 1992).

use nalgebra::{SMatrix, SVector};

use crate::limits::JACOBI_SWEEPS;
use crate::scalar::Scalar;

/// The decomposition A V = U Σ of a square matrix A: the columns of U Σ, and V.
pub(super) struct SingularValues<const B: usize> {
    pub(super) products: SMatrix<f64, B, B>,
    pub(super) right: SMatrix<f64, B, B>,
}

impl<const B: usize> SingularValues<B> {
    pub(super) fn of(matrix: SMatrix<f64, B, B>) -> Self {
        let mut found = Self {
            products: matrix,
            right: SMatrix::identity(),
        };
        for _ in 0..JACOBI_SWEEPS {
            let mut rotated = false;
            for i in 0..B {
                for j in i + 1..B {
                    rotated |= found.rotate(i, j);
                }
            }
            if !rotated {
                break;
            }
        }
        found
    }

    /// Returns the singular values, in no particular order.
    pub(super) fn values(&self) -> SVector<f64, B> {
        SVector::from_fn(|i, _| self.products.column(i).norm())
    }

    /// Makes two columns orthogonal, and returns whether a rotation was necessary.
    fn rotate(&mut self, i: usize, j: usize) -> bool {
        let (first, second) = (self.products.column(i), self.products.column(j));
        let (a, b, c) = (
            first.norm_squared(),
            second.norm_squared(),
            first.dot(&second),
        );
        if c.abs() <= f64::EPSILON * Scalar::sqrt(a * b) || !c.is_finite() {
            return false;
        }
        let zeta = (b - a) / (2.0 * c);
        let tangent = zeta.signum() / (zeta.abs() + Scalar::sqrt(1.0 + zeta * zeta));
        let cosine = 1.0 / Scalar::sqrt(1.0 + tangent * tangent);
        let sine = cosine * tangent;
        for matrix in [&mut self.products, &mut self.right] {
            for k in 0..B {
                let (x, y) = (matrix[(k, i)], matrix[(k, j)]);
                matrix[(k, i)] = cosine * x - sine * y;
                matrix[(k, j)] = sine * x + cosine * y;
            }
        }
        true
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_factors_are_orthogonal_and_give_the_matrix_back() {
        let matrix = SMatrix::<f64, 3, 3>::new(1.0, 2.0, 3.0, 0.0, 1e-9, 5.0, 0.0, 0.0, 2.0);
        let found = SingularValues::of(matrix);
        let back = found.products * found.right.transpose();
        assert!((back - matrix).norm() < 1e-14);
        let gram = found.products.transpose() * found.products;
        let values = found.values();
        assert!((gram - SMatrix::from_diagonal(&values.component_mul(&values))).norm() < 1e-13);
        // The determinant is the product of the singular values, one of which is tiny.
        assert!((values.product() / 2e-9 - 1.0).abs() < 1e-6, "{values}");
    }
}
