//! Products of matrices.
//!
//! A product of rotations knows its factors. A vector is multiplied by one factor after the other where that
//! costs no more than the product with the elements.

use crate::frames::factor::MatrixFactor;
use crate::frames::matrix::{Matrix, Structure};
use crate::limits::MAX_SUCCESSIVE_FACTORS;
use crate::{Expression, Geometry, Graph, Rational};

impl Geometry {
    /// A·B, unless A has not as many columns as B has rows.
    pub fn matrix_product(&mut self, left: &Matrix, right: &Matrix) -> Option<Matrix> {
        if left.columns() != right.rows() {
            return None;
        }
        if left.shape() == (1, 3) && right.shape() == (3, 1) {
            let product = self.dot_product(&left.transpose(), right)?;
            return Some(Matrix::vector(vec![product]));
        }
        if let Some(product) = self.homogeneous_product(left, right) {
            return Some(product);
        }
        match (self.matrix_factors(left), self.matrix_factors(right)) {
            (Some(first), Some(second)) => {
                Some(self.product_of_factors(left, right, first, second))
            }
            (Some(factors), None) => Some(self.product_with_columns(left, &factors, right)),
            (None, Some(_)) => {
                let (matrix, columns) = (right.transpose(), left.transpose());
                let factors = self.matrix_factors(&matrix)?;
                let product = self.product_with_columns(&matrix, &factors, &columns);
                Some(product.transpose())
            }
            (None, None) => Some(self.graph.product_of_elements(left, right)),
        }
    }

    /// The product of a matrix that has these factors with columns, by factors or by elements, whichever is cheaper.
    fn product_with_columns(
        &mut self,
        matrix: &Matrix,
        factors: &[MatrixFactor],
        columns: &Matrix,
    ) -> Matrix {
        if columns.shape() == (3, 1)
            && let Some(product) = self.unresolved_product(factors, columns)
        {
            return product;
        }
        let mut product = self.graph.product_of_elements(matrix, columns);
        if let Some(factors) = matrix.factors()
            && let Some(successive) = self.graph.rotated(factors, columns)
            && self.graph.cost(successive.elements()) <= self.graph.cost(product.elements())
        {
            product = successive;
        }
        if columns.columns() != 1 {
            return product;
        }
        let parts = self.rotated_parts(factors, columns);
        if !columns.parts().is_empty() {
            let sum = self.sum_of_parts(&parts);
            if self.graph.cost(&sum) < self.graph.cost(product.elements()) {
                product = Matrix::vector(sum.to_vec());
            }
        }
        self.with_parts(product, parts)
    }

    /// A product of square matrices, with the factors of both.
    fn product_of_factors(
        &mut self,
        left: &Matrix,
        right: &Matrix,
        first: Vec<MatrixFactor>,
        second: Vec<MatrixFactor>,
    ) -> Matrix {
        let count = first.len() + second.len();
        let factors = self.merged(first.into_iter().chain(second));
        if factors.len() < count {
            return self.product_of(factors);
        }
        let product = self.graph.product_of_elements(left, right);
        product.with_structure(Structure::Product(factors))
    }

    /// The matrix that is the product of these factors, from the left to the right.
    pub(crate) fn product_of(&mut self, factors: Vec<MatrixFactor>) -> Matrix {
        let mut product = self.graph.identity_matrix(3);
        for factor in &factors {
            let elements = factor.elements(&mut self.graph).to_vec();
            let factor = Matrix::with_elements(3, 3, elements);
            product = self.graph.product_of_elements(&product, &factor);
        }
        product.with_structure(Structure::Product(factors))
    }
}

impl Graph {
    /// The matrix with the elements Σⱼ Aᵢⱼ Bⱼₖ.
    fn product_of_elements(&mut self, left: &Matrix, right: &Matrix) -> Matrix {
        Matrix::from_function(left.rows(), right.columns(), |i, k| {
            let pairs = (0..left.columns()).map(|j| (left.at(i, j), right.at(j, k)));
            self.sum_of_products(pairs)
        })
    }

    /// Σ xᵢ·yᵢ.
    pub(crate) fn sum_of_products(
        &mut self,
        pairs: impl IntoIterator<Item = (Expression, Expression)>,
    ) -> Expression {
        let mut terms = Vec::new();
        for (x, y) in pairs {
            terms.push((self.multiply(x, y), Rational::ONE));
        }
        self.sum(terms)
    }

    /// The columns of a matrix, rotated by the last factor first, unless there are too many factors.
    fn rotated(&mut self, factors: &[MatrixFactor], matrix: &Matrix) -> Option<Matrix> {
        if factors.len() > MAX_SUCCESSIVE_FACTORS {
            return None;
        }
        let mut elements = Vec::new();
        for column in matrix.elements().chunks(3) {
            elements.extend(self.turned_by(factors, column.try_into().ok()?));
        }
        Matrix::new(3, matrix.columns(), elements)
    }
}
