//! Eigenvalues of real matrices, by the QR algorithm with implicit double shifts.
//!
//! Balancing: B. N. Parlett and C. Reinsch, *Balancing a matrix for calculation of eigenvalues and eigenvectors*,
//! Numer. Math. **13** (1969) 293–304. Hessenberg form by Householder reflections and Francis's steps: G. H. Golub and
//! C. F. Van Loan, *Matrix Computations*, 4th edition (2013), algorithms 7.4.2, 7.5.1 and 7.5.2; exceptional shifts
//! follow R. S. Martin, G. Peters and J. H. Wilkinson, *The QR algorithm for real Hessenberg matrices*, Numer. Math.
//! **14** (1970) 219–231. Complex eigenvalues come in exactly conjugate pairs. The matrix is the leading block of a
//! slice, so its order need not be a constant.

use nalgebra::{Complex, SMatrix};

use crate::limits::analysis::{BALANCED, EXCEPTIONAL_SHIFT, QR_STEPS};

/// A square matrix in a slice, overwritten; rows and columns may be interchanged, since the transpose has equal
/// eigenvalues.
struct Square<'a> {
    entries: &'a mut [f64],
    stride: usize,
    order: usize,
}

impl core::ops::Index<(usize, usize)> for Square<'_> {
    type Output = f64;

    fn index(&self, (i, j): (usize, usize)) -> &f64 {
        &self.entries[i * self.stride + j]
    }
}

impl core::ops::IndexMut<(usize, usize)> for Square<'_> {
    fn index_mut(&mut self, (i, j): (usize, usize)) -> &mut f64 {
        &mut self.entries[i * self.stride + j]
    }
}

/// Writes the eigenvalues of a matrix's leading block to the front of `found`, and destroys the matrix.
///
/// The block has the given order, and the rows of the matrix are `stride` long. Returns `false` if an entry is not
/// finite or the iteration does not converge.
pub(crate) fn eigenvalues(
    entries: &mut [f64],
    stride: usize,
    order: usize,
    found: &mut [Complex<f64>],
) -> bool {
    let mut matrix = Square {
        entries,
        stride,
        order,
    };
    let rows = 0..order;
    let is_finite = |i: usize| (0..order).all(|j| matrix[(i, j)].is_finite());
    if !rows.clone().all(is_finite) {
        return false;
    }
    matrix.balance(&mut |_, _| {});
    matrix.reduce_to_hessenberg();
    matrix.deflate(found)
}

/// Returns the exponents of the powers of two D for which D⁻¹ A D is balanced; all are 0 if an entry is not finite.
pub(super) fn balancing<const D: usize>(matrix: &SMatrix<f64, D, D>) -> [i32; D] {
    let mut exponents = [0; D];
    let mut entries: [[f64; D]; D] =
        core::array::from_fn(|i| core::array::from_fn(|j| matrix[(i, j)]));
    balance(entries.as_flattened_mut(), &mut exponents);
    exponents
}

/// Balances a matrix that is stored by rows in a slice, and adds the exponents of its units to `exponents`, one for
/// each row.
pub(super) fn balance(entries: &mut [f64], exponents: &mut [i32]) {
    if entries.iter().all(|x| x.is_finite()) {
        let mut square = Square {
            entries,
            stride: exponents.len(),
            order: exponents.len(),
        };
        square.balance(&mut |i, exponent| exponents[i] += exponent);
    }
}

impl Square<'_> {
    /// Scales rows and columns by powers of two, so that their sums have similar sizes. Calls `scaled` with each
    /// exponent by which the unit of a variable grows.
    fn balance(&mut self, scaled: &mut dyn FnMut(usize, i32)) {
        let mut done = false;
        while !done {
            done = true;
            for i in 0..self.order {
                let others = || (0..self.order).filter(|j| *j != i);
                let mut column: f64 = others().map(|j| self[(j, i)].abs()).sum();
                let row: f64 = others().map(|j| self[(i, j)].abs()).sum();
                if !(column > 0.0 && row > 0.0 && (column + row).is_finite()) {
                    continue;
                }
                let before = column + row;
                let mut exponent = 0;
                while column < row / 2.0 {
                    exponent += 1;
                    column *= 4.0;
                }
                while column >= row * 2.0 {
                    exponent -= 1;
                    column /= 4.0;
                }
                let scale = libm::ldexp(1.0, exponent);
                if (column + row) / scale < BALANCED * before {
                    done = false;
                    scaled(i, exponent);
                    for j in 0..self.order {
                        self[(i, j)] /= scale;
                    }
                    for j in 0..self.order {
                        self[(j, i)] *= scale;
                    }
                }
            }
        }
    }

    /// Applies Householder reflections; the vector of each is kept in its column until the column is overwritten.
    fn reduce_to_hessenberg(&mut self) {
        let n = self.order;
        for k in 0..n.saturating_sub(2) {
            let below: f64 = (k + 2..n).map(|i| self[(i, k)].abs()).sum();
            if below <= 0.0 {
                continue;
            }
            let scale = below + self[(k + 1, k)].abs();
            for i in k + 1..n {
                self[(i, k)] /= scale;
            }
            let squares: f64 = (k + 1..n).map(|i| self[(i, k)] * self[(i, k)]).sum();
            let first = self[(k + 1, k)];
            let alpha = -libm::copysign(libm::sqrt(squares), first);
            self[(k + 1, k)] = first - alpha;
            // 2/vᵀv, with vᵀv = 2 (|x|² − α x₁).
            let factor = 1.0 / (squares - alpha * first);
            for j in k + 1..n {
                let product: f64 = (k + 1..n).map(|i| self[(i, k)] * self[(i, j)]).sum();
                for i in k + 1..n {
                    let change = factor * product * self[(i, k)];
                    self[(i, j)] -= change;
                }
            }
            for i in 0..n {
                let product: f64 = (k + 1..n).map(|j| self[(j, k)] * self[(i, j)]).sum();
                for j in k + 1..n {
                    let change = factor * product * self[(j, k)];
                    self[(i, j)] -= change;
                }
            }
            self[(k + 1, k)] = alpha * scale;
            for i in k + 2..n {
                self[(i, k)] = 0.0;
            }
        }
    }

    /// Applies Francis's steps to the trailing unreduced block, until one or two eigenvalues split off.
    fn deflate(&mut self, found: &mut [Complex<f64>]) -> bool {
        let mut left = self.order;
        let mut steps = 0;
        while left > 0 {
            let high = left - 1;
            let low = self.first_of_unreduced_block(high);
            if low == high {
                found[high] = Complex::new(self[(high, high)], 0.0);
                left -= 1;
                steps = 0;
            } else if low + 1 == high {
                let pair = self.of_pair(low);
                found[low..=high].copy_from_slice(&pair);
                left -= 2;
                steps = 0;
            } else {
                if steps == QR_STEPS {
                    return false;
                }
                steps += 1;
                self.francis_step(low, high, steps % EXCEPTIONAL_SHIFT == 0);
            }
        }
        true
    }

    fn first_of_unreduced_block(&mut self, high: usize) -> usize {
        for i in (1..=high).rev() {
            let mut size = self[(i - 1, i - 1)].abs() + self[(i, i)].abs();
            if size <= 0.0 {
                let row = (i - 1..=high).map(|j| self[(i - 1, j)].abs());
                size = row.sum();
            }
            if self[(i, i - 1)].abs() <= f64::EPSILON * size {
                self[(i, i - 1)] = 0.0;
                return i;
            }
        }
        0
    }

    /// Returns the eigenvalues of a block of order 2.
    fn of_pair(&self, i: usize) -> [Complex<f64>; 2] {
        let [a, b] = [self[(i, i)], self[(i, i + 1)]];
        let [c, d] = [self[(i + 1, i)], self[(i + 1, i + 1)]];
        let half = 0.5 * (a - d);
        let discriminant = half * half + b * c;
        if discriminant >= 0.0 {
            let z = half + libm::copysign(libm::sqrt(discriminant), half);
            let second = if z.abs() > 0.0 { d - b * c / z } else { d };
            return [Complex::new(d + z, 0.0), Complex::new(second, 0.0)];
        }
        let imaginary = libm::sqrt(-discriminant);
        let real = d + half;
        [
            Complex::new(real, imaginary),
            Complex::new(real, -imaginary),
        ]
    }

    /// Performs one step with a pair of shifts, on the rows and columns of the block.
    fn francis_step(&mut self, low: usize, high: usize, exceptional: bool) {
        let before = high - 1;
        let (sum, product) = if exceptional {
            let size = self[(high, before)].abs() + self[(before, before - 1)].abs();
            (1.5 * size, size * size)
        } else {
            let diagonal = self[(before, before)] * self[(high, high)];
            (
                self[(before, before)] + self[(high, high)],
                diagonal - self[(before, high)] * self[(high, before)],
            )
        };
        let [first, next] = [self[(low, low)], self[(low + 1, low + 1)]];
        let subdiagonal = self[(low + 1, low)];
        let mut column = [
            first * (first - sum) + self[(low, low + 1)] * subdiagonal + product,
            subdiagonal * (first + next - sum),
            subdiagonal * self[(low + 2, low + 1)],
        ];
        for k in low..high {
            let size = if k + 2 <= high { 3 } else { 2 };
            self.reflect(&column[..size], k, low, high);
            for (i, entry) in column.iter_mut().enumerate() {
                *entry = if k + 1 + i <= high {
                    self[(k + 1 + i, k)]
                } else {
                    0.0
                };
            }
        }
    }

    /// Applies the similarity transformation that takes `column`, in the rows from k on, to a multiple of the first
    /// unit vector.
    fn reflect(&mut self, column: &[f64], k: usize, low: usize, high: usize) {
        let scale = column.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
        if scale <= 0.0 {
            return;
        }
        let mut v = [0.0; 3];
        for (entry, x) in v.iter_mut().zip(column) {
            *entry = x / scale;
        }
        let squares: f64 = v.iter().map(|x| x * x).sum();
        let first = v[0];
        let alpha = -libm::copysign(libm::sqrt(squares), first);
        v[0] -= alpha;
        let factor = 1.0 / (squares - alpha * first);
        let size = column.len();
        for j in k.saturating_sub(1).max(low)..=high {
            let product: f64 = (0..size).map(|i| v[i] * self[(k + i, j)]).sum();
            for i in 0..size {
                self[(k + i, j)] -= factor * product * v[i];
            }
        }
        for i in low..=(k + 3).min(high) {
            let product: f64 = (0..size).map(|j| v[j] * self[(i, k + j)]).sum();
            for j in 0..size {
                self[(i, k + j)] -= factor * product * v[j];
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use nalgebra::Complex;

    use super::eigenvalues;

    fn of<const N: usize>(rows: [[f64; N]; N]) -> std::vec::Vec<Complex<f64>> {
        let mut rows = rows;
        let mut found = std::vec![Complex::new(f64::NAN, f64::NAN); N];
        assert!(eigenvalues(rows.as_flattened_mut(), N, N, &mut found));
        found.sort_by(|a, b| a.re.total_cmp(&b.re).then(a.im.total_cmp(&b.im)));
        found
    }

    #[track_caller]
    fn assert_close(found: &[Complex<f64>], expected: &[(f64, f64)], tolerance: f64) {
        assert_eq!(found.len(), expected.len());
        for (found, (re, im)) in found.iter().zip(expected) {
            let error = (found - Complex::new(*re, *im)).norm_sqr().sqrt();
            assert!(
                error <= tolerance,
                "{found} is not {re} + {im} i: {error:e}"
            );
        }
    }

    #[test]
    fn companion_matrices() {
        // (x − 1)(x − 2)(x − 3)(x² + 1) = x⁵ − 6 x⁴ + 12 x³ − 12 x² + 11 x − 6.
        let found = of([
            [6.0, -12.0, 12.0, -11.0, 6.0],
            [1.0, 0.0, 0.0, 0.0, 0.0],
            [0.0, 1.0, 0.0, 0.0, 0.0],
            [0.0, 0.0, 1.0, 0.0, 0.0],
            [0.0, 0.0, 0.0, 1.0, 0.0],
        ]);
        let expected = [(0.0, -1.0), (0.0, 1.0), (1.0, 0.0), (2.0, 0.0), (3.0, 0.0)];
        assert_close(&found, &expected, 1e-12);
        assert!(found[0] == found[1].conj());
    }

    /// The iteration would not converge without exceptional shifts.
    #[test]
    fn cyclic_permutation() {
        let found = of([
            [0.0, 0.0, 0.0, 1.0],
            [1.0, 0.0, 0.0, 0.0],
            [0.0, 1.0, 0.0, 0.0],
            [0.0, 0.0, 1.0, 0.0],
        ]);
        let expected = [(-1.0, 0.0), (0.0, -1.0), (0.0, 1.0), (1.0, 0.0)];
        assert_close(&found, &expected, 1e-14);
    }

    #[test]
    fn badly_scaled() {
        let found = of([[1.0, 1e12, 0.0], [1e-12, 2.0, 1e10], [0.0, 1e-10, 3.0]]);
        // The eigenvalues of (1, 1, 0; 1, 2, 1; 0, 1, 3).
        let root = 3.0_f64.sqrt();
        let expected = [(2.0 - root, 0.0), (2.0, 0.0), (2.0 + root, 0.0)];
        assert_close(&found, &expected, 1e-13);
    }

    #[test]
    fn zero_and_scalar_matrices() {
        assert_close(&of([[0.0; 3]; 3]), &[(0.0, 0.0); 3], 0.0);
        assert_close(&of([[-2.5]]), &[(-2.5, 0.0)], 0.0);
        assert_close(&of([[0.0, 1.0], [0.0, 0.0]]), &[(0.0, 0.0); 2], 0.0);
    }

    #[test]
    fn what_is_not_finite_is_refused() {
        let mut rows = [[1.0, f64::NAN], [0.0, 1.0]];
        let mut found = [Complex::new(0.0, 0.0); 2];
        assert!(!eigenvalues(rows.as_flattened_mut(), 2, 2, &mut found));
    }

    /// Checks the trace and the sum of squares of leading blocks of random matrices.
    #[test]
    fn sums_of_random_matrices() {
        let mut seed = 1_u64;
        let mut draw = || {
            seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
            f64::from(u32::try_from(seed >> 40).unwrap()) / f64::from(1 << 24) - 0.5
        };
        for order in 1..=9 {
            for _ in 0..50 {
                let mut rows = [[0.0; 9]; 9];
                for row in &mut rows {
                    row.fill_with(&mut draw);
                }
                let trace: f64 = (0..order).map(|i| rows[i][i]).sum();
                let pairs = (0..order).flat_map(|i| (0..order).map(move |j| (i, j)));
                let squares: f64 = pairs.map(|(i, j)| rows[i][j] * rows[j][i]).sum();
                let mut found = [Complex::new(0.0, 0.0); 9];
                assert!(eigenvalues(rows.as_flattened_mut(), 9, order, &mut found));
                let sum: Complex<f64> = found[..order].iter().sum();
                let sum_of_squares: Complex<f64> = found[..order].iter().map(|x| x * x).sum();
                assert!((sum - trace).norm_sqr().sqrt() < 1e-13);
                assert!((sum_of_squares - squares).norm_sqr().sqrt() < 1e-13);
            }
        }
    }
}
