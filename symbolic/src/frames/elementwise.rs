//! Elementwise operations on matrices: sums, multiples, component products, time derivatives.

use crate::frames::matrix::Matrix;
use crate::{Expression, Geometry, Graph, Rational};

impl Geometry {
    /// Σ cᵢ·Aᵢ of pairs (Aᵢ, cᵢ), unless there are none or their shapes differ.
    pub fn matrix_sum(&mut self, terms: &[(&Matrix, Rational)]) -> Option<Matrix> {
        let [(first, number), others @ ..] = terms else {
            return None;
        };
        if others.iter().any(|(x, _)| x.shape() != first.shape()) {
            return None;
        }
        if others.is_empty() && number.is_one() {
            return Some((*first).clone());
        }
        let factors = terms.iter().map(|(x, c)| (*x, self.graph.constant(c)));
        let factors: Vec<_> = factors.collect();
        Some(self.sum_with(&factors, |graph| {
            Matrix::from_function(first.rows(), first.columns(), |i, j| {
                graph.sum(terms.iter().map(|(x, c)| (x.at(i, j), c.clone())))
            })
        }))
    }

    /// A matrix with each of its elements multiplied by the same factor.
    pub fn matrix_scaled(&mut self, matrix: &Matrix, factor: Expression) -> Matrix {
        if factor == self.graph.one() {
            return matrix.clone();
        }
        self.sum_with(&[(matrix, factor)], |graph| {
            matrix.map(|x| graph.multiply(factor, x))
        })
    }

    /// The total time derivative of a matrix of a system with `coordinates` degrees of freedom.
    pub fn matrix_time_derivative(&mut self, matrix: &Matrix, coordinates: u32) -> Matrix {
        if matrix.shape() == (3, 1)
            && let Some(rate) = self.unresolved_rate(matrix)
        {
            return rate;
        }
        if let Some(rate) = self.homogeneous_rate(matrix) {
            return rate;
        }
        let derivatives = self.time_derivatives(matrix.elements(), coordinates);
        let derivative = Matrix::with_elements(matrix.rows(), matrix.columns(), derivatives);
        let parts = self.parts_of_derivative(matrix, coordinates);
        self.with_parts(derivative, parts)
    }
}

impl Graph {
    /// The identity matrix.
    #[must_use]
    pub fn identity_matrix(&self, size: usize) -> Matrix {
        let element = |i: usize, j: usize| if i == j { self.one() } else { self.zero() };
        Matrix::from_function(size, size, element)
    }

    /// The matrix with the components of a vector, a row or a column, on its diagonal.
    #[must_use]
    pub fn diagonal_matrix(&self, vector: &Matrix) -> Option<Matrix> {
        let components = vector.elements();
        let element = |i: usize, j: usize| if i == j { components[i] } else { self.zero() };
        let size = components.len();
        vector
            .is_vector()
            .then(|| Matrix::from_function(size, size, element))
    }

    /// The matrix of the products of elements in the same place, unless the shapes differ.
    pub fn component_product(&mut self, x: &Matrix, y: &Matrix) -> Option<Matrix> {
        let element = |i: usize, j: usize| self.multiply(x.at(i, j), y.at(i, j));
        (x.shape() == y.shape()).then(|| Matrix::from_function(x.rows(), x.columns(), element))
    }
}
