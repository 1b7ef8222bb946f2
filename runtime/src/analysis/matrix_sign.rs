//! Stabilizing solutions of Riccati equations by the sign of a Hamiltonian matrix, in double-double arithmetic.
//!
//! J. D. Roberts, *Linear model reduction and solution of the algebraic Riccati equation by use of the sign function*,
//! Int. J. Control **32** (1980) 677–687; R. Byers, *Solving the algebraic Riccati equation with the matrix sign
//! function*, Linear Algebra Appl. **85** (1987) 267–279, with steps scaled by norms (N. J. Higham, *Functions of
//! Matrices*, 2008, section 5.5). A discrete equation becomes a continuous one by z = (1 + s)/(1 − s), which takes the
//! unit circle to the imaginary axis: V. Mehrmann, *A step toward a unified treatment of continuous and discrete time
//! control problems*, Linear Algebra Appl. **241–243** (1996) 749–779. States without cost may be stable or unstable,
//! and weights and rates may have very different sizes: the iteration then loses digits, but only beyond the precision
//! of `f64`.

use super::eigenvalues::balance;
use super::lyapunov::{Square, form_in_units, map_in_units};
use crate::limits::analysis::SIGN_ITERATIONS;
use crate::linalg::largest;
use crate::scalar::{DoubleDouble, Scalar};

/// A matrix of order 2 `D`, stored by rows.
#[derive(Clone, Copy)]
struct Double<const D: usize>([[[[DoubleDouble; D]; 2]; D]; 2]);

fn number(value: f64) -> DoubleDouble {
    DoubleDouble::from(value)
}

impl<const D: usize> Double<D> {
    fn of(blocks: [[&Square<D>; 2]; 2]) -> Self {
        Self(core::array::from_fn(|p| {
            core::array::from_fn(|i| {
                core::array::from_fn(|q| core::array::from_fn(|j| blocks[p][q][(i, j)]))
            })
        }))
    }

    fn rows(&mut self) -> &mut [[[DoubleDouble; D]; 2]] {
        self.0.as_flattened_mut()
    }

    fn norm(&self) -> f64 {
        let entries = self.0.as_flattened().as_flattened().as_flattened();
        let largest = largest(entries);
        if !(largest > 0.0 && largest.is_finite()) {
            return largest;
        }
        let squares = entries.iter().map(|x| x.to_f64() / largest);
        largest * libm::sqrt(squares.map(|x| x * x).sum())
    }

    /// Returns the inverse times another matrix, by elimination with row pivoting; rows are compared in their own
    /// scale.
    fn solve(mut self, mut right: Self) -> Self {
        let order = 2 * D;
        for k in 0..order {
            let rows = self.rows();
            let weight = |i: usize| {
                let pivot = rows[i].as_flattened()[k].to_f64().abs();
                pivot / largest(rows[i].as_flattened())
            };
            let pivot = (k..order).fold((k, -1.0), |best, i| {
                let weight = weight(i);
                if weight > best.1 { (i, weight) } else { best }
            });
            rows.swap(k, pivot.0);
            right.rows().swap(k, pivot.0);
            let row = self.rows()[k];
            let of_right = right.rows()[k];
            let reciprocal = number(1.0) / row.as_flattened()[k];
            for i in (0..order).filter(|i| *i != k) {
                let factor = self.rows()[i].as_flattened()[k] * reciprocal;
                if factor.to_f64() == 0.0 {
                    continue;
                }
                let entries = self.rows()[i].as_flattened_mut().iter_mut();
                for (x, y) in entries.zip(row.as_flattened()).skip(k) {
                    *x -= factor * *y;
                }
                let entries = right.rows()[i].as_flattened_mut().iter_mut();
                for (x, y) in entries.zip(of_right.as_flattened()) {
                    *x -= factor * *y;
                }
            }
        }
        for k in 0..order {
            let pivot = self.rows()[k].as_flattened()[k];
            for x in right.rows()[k].as_flattened_mut() {
                *x /= pivot;
            }
        }
        right
    }

    /// Returns the sign of the matrix: 1 on eigenvalues in the right half plane, −1 in the left one; `None` if an
    /// eigenvalue is on the imaginary axis.
    fn sign(mut self) -> Option<Self> {
        let one = Square::identity();
        let zero = Square::zeros();
        let identity = Self::of([[&one, &zero], [&zero, &one]]);
        let mut is_near = false;
        for _ in 0..SIGN_ITERATIONS {
            let inverse = self.solve(identity);
            let [size, of_inverse] = [self.norm(), inverse.norm()];
            if !(size.is_finite() && of_inverse.is_finite() && of_inverse > 0.0) {
                return None;
            }
            // A power of two, so that scaling has no rounding errors.
            let scale = libm::sqrt(of_inverse / size);
            let scale = libm::ldexp(1.0, libm::ilogb(scale * core::f64::consts::SQRT_2));
            let scale = if is_near { 1.0 } else { scale };
            let (half, of_inverse) = (number(0.5 * scale), number(0.5 / scale));
            let mut change = self;
            let pairs = self.rows().as_flattened_mut().as_flattened_mut().iter_mut();
            let inverses = inverse.0.as_flattened().as_flattened().as_flattened();
            let changes = change.rows().as_flattened_mut().as_flattened_mut();
            for ((x, y), change) in pairs.zip(inverses).zip(changes) {
                let next = *x * half + *y * of_inverse;
                *change = next - *x;
                *x = next;
            }
            let left = change.norm() / self.norm();
            // Convergence is quadratic: the next step leaves the square of this change.
            if is_near && left < 1e-17 {
                return Some(self);
            }
            is_near = left < 0.1;
        }
        None
    }
}

/// Solves S₁₂ X = −(S₁₁ + 1), (S₂₂ + 1) X = −S₂₁ for X, where S is the sign.
///
/// The columns (1, X) span the stable subspace. The method reflects the columns of the left-hand side (Householder).
fn solution<const D: usize>(sign: &Double<D>) -> Square<D> {
    let one = number(1.0);
    let mut left = [[[DoubleDouble::default(); D]; D]; 2];
    let mut right = left;
    for p in 0..2 {
        for i in 0..D {
            for j in 0..D {
                let unit = if i == j { one } else { number(0.0) };
                left[p][i][j] = sign.0[p][i][1][j] + if p == 1 { unit } else { number(0.0) };
                right[p][i][j] = -(sign.0[p][i][0][j] + if p == 0 { unit } else { number(0.0) });
            }
        }
    }
    let [left, right] = [&mut left, &mut right].map(|x| x.as_flattened_mut());
    for k in 0..D {
        let column = left.iter().skip(k).map(|row| row[k] * row[k]);
        let length = column.fold(number(0.0), |sum, x| sum + x).sqrt();
        let length = if left[k][k].to_f64() > 0.0 {
            -length
        } else {
            length
        };
        let divisor = length * (length - left[k][k]);
        if divisor.to_f64() == 0.0 {
            continue;
        }
        let mut v = [[number(0.0); D]; 2];
        let v = v.as_flattened_mut();
        for i in k..2 * D {
            v[i] = left[i][k] - if i == k { length } else { number(0.0) };
        }
        for matrix in [&mut *left, &mut *right] {
            #[allow(clippy::needless_range_loop)] // A column.
            for j in 0..D {
                let products = (k..2 * D).map(|i| v[i] * matrix[i][j]);
                let factor = products.fold(number(0.0), |sum, x| sum + x) / divisor;
                for i in k..2 * D {
                    matrix[i][j] -= factor * v[i];
                }
            }
        }
    }
    let mut x = Square::<D>::zeros();
    for j in 0..D {
        for i in (0..D).rev() {
            let known = (i + 1..D).map(|k| left[i][k] * x[(k, j)]);
            let rest = known.fold(right[i][j], |rest, x| rest - x);
            x[(i, j)] = rest / left[i][i];
        }
    }
    (x + x.transpose()) * number(0.5)
}

/// Returns the exponents of units x = T x′ of the state and y = T⁻¹ y′ of the costate in which the Hamiltonian matrix
/// is balanced: P. Benner, *Symplectic balancing of Hamiltonian matrices*, SIAM J. Sci. Comput. **22** (2001)
/// 1885–1904.
fn units<const D: usize>(hamiltonian: &Double<D>) -> [i32; D] {
    let entries = hamiltonian
        .0
        .map(|half| half.map(|row| row.map(|half| half.map(DoubleDouble::to_f64))));
    let mut entries = entries;
    let flat = entries.as_flattened_mut().as_flattened_mut();
    let mut exponents = [[0; D]; 2];
    balance(flat.as_flattened_mut(), exponents.as_flattened_mut());
    let [states, costates] = exponents;
    core::array::from_fn(|i| (states[i] - costates[i]) / 2)
}

/// Returns the stabilizing solution X of Aᵀ X + X A − X G X + Q = 0, or of X = Aᵀ X (1 + G X)⁻¹ A + Q.
pub(super) fn stabilizing<const D: usize>(
    a: &Square<D>,
    g: &Square<D>,
    q: &Square<D>,
    is_discrete: bool,
) -> Option<Square<D>> {
    let negative = |matrix: &Square<D>| -*matrix;
    let hamiltonian = Double::of([[a, &negative(g)], [&negative(q), &negative(&a.transpose())]]);
    let units = units(&hamiltonian);
    let back = units.map(|n| -n);
    let (a, q) = (&map_in_units(a, &units), &form_in_units(q, &units));
    let g = &form_in_units(g, &back);
    let transposed = a.transpose();
    let hamiltonian = if is_discrete {
        // The sum and the difference of both sides of A x = z (x + G y) and −Q x + y = z Aᵀ y.
        let one = Square::<D>::identity();
        let sum = Double::of([[&(a + one), g], [&-q, &(one + transposed)]]);
        let difference = Double::of([[&(a - one), &-g], [&-q, &(one - transposed)]]);
        sum.solve(difference)
    } else {
        Double::of([[a, &-g], [&-q, &-transposed]])
    };
    let found = solution(&hamiltonian.sign()?);
    let is_finite = found.iter().all(|x| x.is_finite());
    is_finite.then(|| form_in_units(&found, &back))
}
