//! Square matrices of numbers.

use crate::validation::sum_with_size::SumWithSize;

/// A square matrix, row by row.
pub(crate) struct SquareMatrix {
    elements: Vec<f64>,
    size: usize,
}

impl SquareMatrix {
    pub(crate) fn new(elements: Vec<f64>, size: usize) -> Self {
        Self { elements, size }
    }

    /// The symmetric matrix with this lower triangle, row by row.
    pub(crate) fn symmetric(lower: &[f64], size: usize) -> Self {
        let mut elements = vec![0.0; size * size];
        for i in 0..size {
            for j in 0..=i {
                let element = lower[i * (i + 1) / 2 + j];
                elements[i * size + j] = element;
                elements[j * size + i] = element;
            }
        }
        Self { elements, size }
    }

    /// The matrix of the saddle point problem for this mass matrix and the Jacobian G of so many constraints, column by
    /// column.
    pub(crate) fn with_constraints(&self, jacobian: &[f64], constraints: usize) -> Self {
        let size = self.size + constraints;
        let mut elements = vec![0.0; size * size];
        for i in 0..self.size {
            for j in 0..self.size {
                elements[i * size + j] = self.elements[i * self.size + j];
            }
            for j in 0..constraints {
                let entry = -jacobian[i * constraints + j];
                elements[i * size + self.size + j] = entry;
                elements[(self.size + j) * size + i] = entry;
            }
        }
        Self { elements, size }
    }

    /// The product with a vector.
    pub(crate) fn times(&self, vector: &[f64]) -> Vec<SumWithSize> {
        let mut products = vec![SumWithSize::default(); self.size];
        for (i, product) in products.iter_mut().enumerate() {
            for (j, x) in vector.iter().enumerate() {
                product.add(self.elements[i * self.size + j] * x);
            }
        }
        products
    }

    /// x in A x = b, by elimination with partial pivoting (Golub and Van Loan, Matrix Computations, 4th
    /// edition 2013, algorithm 3.4.1); none of a singular matrix.
    pub(crate) fn solve(mut self, right: &[f64]) -> Option<Vec<f64>> {
        let n = self.size;
        let mut solution = right.to_vec();
        for k in 0..n {
            let mut pivot = k;
            for i in k + 1..n {
                if self.elements[i * n + k].abs() > self.elements[pivot * n + k].abs() {
                    pivot = i;
                }
            }
            if self.elements[pivot * n + k] == 0.0 {
                return None;
            }
            for j in 0..n {
                self.elements.swap(k * n + j, pivot * n + j);
            }
            solution.swap(k, pivot);
            for i in k + 1..n {
                let factor = self.elements[i * n + k] / self.elements[k * n + k];
                if factor == 0.0 {
                    continue;
                }
                for j in k + 1..n {
                    self.elements[i * n + j] -= factor * self.elements[k * n + j];
                }
                solution[i] -= factor * solution[k];
            }
        }
        for k in (0..n).rev() {
            for j in k + 1..n {
                solution[k] -= self.elements[k * n + j] * solution[j];
            }
            solution[k] /= self.elements[k * n + k];
        }
        Some(solution)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn solutions_solve() {
        // The first pivot is zero: rows have to be exchanged.
        let lower = [0.0, 2.0, 1.0, 3.0, -1.0, 4.0];
        let expected = [1.5, -2.0, 0.25];
        let right: Vec<f64> = SquareMatrix::symmetric(&lower, 3)
            .times(&expected)
            .iter()
            .map(|balance| balance.total)
            .collect();
        let found = SquareMatrix::symmetric(&lower, 3).solve(&right).unwrap();
        for (found, expected) in found.iter().zip(expected) {
            assert!((found - expected).abs() < 1e-14, "{found} {expected}");
        }
        assert_eq!(
            SquareMatrix::symmetric(&[1.0, 2.0, 4.0], 2).solve(&[1.0, 1.0]),
            None
        );
    }
}
