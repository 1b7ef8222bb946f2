//! The pseudoinverse of a Jacobian that is given row by row, by rotations that make its rows orthogonal.
//!
//! The one-sided Jacobi method: M. R. Hestenes, *Inversion of matrices by biorthogonalization and related results*, J.
//! SIAM **6** (1958) 51–90; J. Demmel and K. Veselić, *Jacobi's method is more accurate than QR*, SIAM J. Matrix Anal.
//! Appl. **13** (1992) 1204–1245. W J = Σ Vᵀ with W orthogonal: the rows of W J are orthogonal, and their lengths are
//! the singular values.

use nalgebra::SVector;

use crate::integrate::SingleNumber;
use crate::limits::analysis::{JACOBI_SWEEPS, SINGULAR};
use crate::linalg::largest_or_nan;
use crate::scalar::Scalar;

/// A number for each variable: `N` coordinates, `N` velocities and `U` inputs.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Variables<S: Scalar, const N: usize, const U: usize> {
    pub(super) positions: SVector<S, N>,
    pub(super) velocities: SVector<S, N>,
    pub(super) inputs: SVector<S, U>,
}

impl<S: Scalar, const N: usize, const U: usize> Variables<S, N, U> {
    pub(super) fn zeros() -> Self {
        Self {
            positions: SVector::zeros(),
            velocities: SVector::zeros(),
            inputs: SVector::zeros(),
        }
    }

    pub(super) fn zip_map(&self, other: &Self, function: impl Fn(S, S) -> S) -> Self {
        Self {
            positions: self.positions.zip_map(&other.positions, &function),
            velocities: self.velocities.zip_map(&other.velocities, &function),
            inputs: self.inputs.zip_map(&other.inputs, &function),
        }
    }

    pub(super) fn components(&self) -> impl Iterator<Item = &S> + '_ {
        let velocities = self.velocities.iter();
        let all = self.positions.iter().chain(velocities);
        all.chain(self.inputs.iter())
    }

    pub(super) fn dot(&self, other: &Self) -> S {
        let pairs = self.components().zip(other.components());
        pairs.fold(S::zero(), |sum, (x, y)| x.mul_add(*y, sum))
    }

    /// Returns the Euclidean length.
    pub(super) fn norm(&self) -> f64 {
        let largest = self.largest();
        if largest > 0.0 && largest.is_finite() {
            let scale = S::from_f64(largest);
            let scaled = self.zip_map(self, |x, _| x / scale);
            scaled.dot(&scaled).sqrt().largest() * largest
        } else {
            largest
        }
    }

    /// Returns the largest magnitude; NaN if a component is NaN.
    pub(super) fn largest(&self) -> f64 {
        largest_or_nan(self.components())
    }
}

/// A right-hand side: one number for the acceleration of each coordinate, and one for its momentum.
pub(super) type Residuals<S, const N: usize> = [SVector<S, N>; 2];

/// A row of W J, and its representation as a combination of the original rows.
#[derive(Clone, Copy, Debug)]
struct Row<S: Scalar, const N: usize, const U: usize> {
    entries: Variables<S, N, U>,
    combination: Residuals<S, N>,
}

/// A factored Jacobian with 2 `N` rows.
#[derive(Clone, Copy, Debug)]
pub(super) struct JacobianRows<S: Scalar, const N: usize, const U: usize> {
    rows: [[Row<S, N, U>; N]; 2],
}

impl<S: SingleNumber, const N: usize, const U: usize> JacobianRows<S, N, U> {
    /// Factors the rows of both blocks.
    pub(super) fn new(rows: &[[Variables<S, N, U>; N]; 2]) -> Self {
        let mut rows = core::array::from_fn(|block| {
            core::array::from_fn(|i| {
                let mut combination = [SVector::zeros(); 2];
                combination[block][i] = S::one();
                Row {
                    entries: rows[block][i],
                    combination,
                }
            })
        });
        for _ in 0..JACOBI_SWEEPS {
            let mut rotated = false;
            for p in 0..2 * N {
                for q in p + 1..2 * N {
                    rotated |= orthogonalize(&mut rows, p, q);
                }
            }
            if !rotated {
                break;
            }
        }
        Self { rows }
    }

    /// Returns the singular values of the rows, in no particular order; all others are 0.
    fn singular_values(&self) -> impl Iterator<Item = f64> + '_ {
        let rows = self.rows.as_flattened().iter();
        rows.map(|row| row.entries.norm())
    }

    /// Returns the largest singular value.
    pub(super) fn largest(&self) -> f64 {
        self.singular_values().fold(0.0, f64::max)
    }

    fn smallest_regular(&self) -> f64 {
        SINGULAR * S::machine_epsilon() * self.largest()
    }

    /// Returns the number of singular values that are not zero up to rounding.
    pub(super) fn rank(&self) -> usize {
        let limit = self.smallest_regular();
        self.singular_values().filter(|size| *size > limit).count()
    }

    /// Returns the ratio of the largest singular value to the smallest nonzero one; 1 if all are zero.
    pub(super) fn condition(&self) -> f64 {
        let limit = self.smallest_regular();
        let regular = self.singular_values().filter(|size| *size > limit);
        let least = regular.fold(f64::INFINITY, f64::min);
        if least.is_finite() {
            self.largest() / least
        } else {
            1.0
        }
    }

    /// Returns the shortest x among all for which J x is nearest to `right`.
    pub(super) fn solve(&self, right: &Residuals<S, N>) -> Variables<S, N, U> {
        let limit = self.smallest_regular();
        let mut x = Variables::zeros();
        for row in self.rows.as_flattened() {
            if row.entries.norm() > limit {
                let factor = row.component(right) / row.entries.dot(&row.entries);
                x = x.zip_map(&row.entries, |sum, entry| entry.mul_add(factor, sum));
            }
        }
        x
    }

    /// Minimizes |J x − right|² + damping |x|².
    ///
    /// Returns x and the decrease of |right|² that the linear model predicts: xᵀ(damping x + Jᵀ right).
    pub(super) fn damped(&self, right: &Residuals<S, N>, damping: S) -> (Variables<S, N, U>, f64) {
        let mut x = Variables::zeros();
        let mut predicted = S::zero();
        for row in self.rows.as_flattened() {
            let square = row.entries.dot(&row.entries);
            if square.largest() > 0.0 {
                let component = row.component(right);
                let factor = component / (square + damping);
                x = x.zip_map(&row.entries, |sum, entry| entry.mul_add(factor, sum));
                predicted += factor * square * (component + damping * factor);
            }
        }
        (x, predicted.largest())
    }
}

impl<S: Scalar, const N: usize, const U: usize> Row<S, N, U> {
    fn component(&self, right: &Residuals<S, N>) -> S {
        self.combination[0].dot(&right[0]) + self.combination[1].dot(&right[1])
    }
}

/// Rotates two rows until they are orthogonal, and returns whether a rotation was necessary.
fn orthogonalize<S: SingleNumber, const N: usize, const U: usize>(
    rows: &mut [[Row<S, N, U>; N]; 2],
    p: usize,
    q: usize,
) -> bool {
    let rows = rows.as_flattened_mut();
    let [first, second] = [rows[p], rows[q]];
    let [of_first, of_second] = [first, second].map(|row| row.entries.dot(&row.entries));
    let product = first.entries.dot(&second.entries);
    let size = product.abs().largest();
    let lengths = of_first.sqrt().largest() * of_second.sqrt().largest();
    // NaN is left unchanged, and so is a row whose square underflows.
    if !(lengths > 0.0 && size > S::machine_epsilon() * lengths) {
        return false;
    }
    let tau = (of_second - of_first) / (product + product);
    let root = (S::one() + tau * tau).sqrt();
    let tangent = if tau.abs().largest() * S::machine_epsilon() > 1.0 {
        // The square may overflow; on dual numbers its derivative would be NaN.
        S::one() / (tau + tau)
    } else if tau.largest() < 0.0 {
        S::one() / (tau - root)
    } else {
        S::one() / (tau + root)
    };
    let cosine = S::one() / (S::one() + tangent * tangent).sqrt();
    let sine = tangent * cosine;
    let less = |x: S, y: S| cosine * x - sine * y;
    let more = |x: S, y: S| sine * x + cosine * y;
    rows[p] = combined(&first, &second, less);
    rows[q] = combined(&first, &second, more);
    true
}

fn combined<S: Scalar, const N: usize, const U: usize>(
    first: &Row<S, N, U>,
    second: &Row<S, N, U>,
    function: impl Fn(S, S) -> S,
) -> Row<S, N, U> {
    let [a, b] = [&first.combination, &second.combination];
    Row {
        entries: first.entries.zip_map(&second.entries, &function),
        combination: [
            a[0].zip_map(&b[0], &function),
            a[1].zip_map(&b[1], &function),
        ],
    }
}
