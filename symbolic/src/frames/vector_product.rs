//! Products of vectors, which may be rows or columns, and their norms.

use crate::frames::matrix::Matrix;
use crate::{Expression, Geometry, Graph, Rational};

impl Geometry {
    /// x · y of two rows or two columns of equal length.
    pub fn dot_product(&mut self, x: &Matrix, y: &Matrix) -> Option<Expression> {
        if !x.is_vector() || x.shape() != y.shape() {
            return None;
        }
        if let Some(product) = self.unresolved_dot_product(x, y) {
            return Some(product);
        }
        if let Some(product) = self.homogeneous_dot_product(x, y) {
            return Some(product);
        }
        let pairs = x.elements().iter().copied();
        let product = self
            .graph
            .sum_of_products(pairs.zip(y.elements().iter().copied()));
        Some(self.or_in_other_frames(product, x, y))
    }

    /// x × y of two rows or two columns of three components.
    pub fn cross_product(&mut self, x: &Matrix, y: &Matrix) -> Option<Matrix> {
        if x.shape() != y.shape() {
            return None;
        }
        if let Some(product) = self.unresolved_cross_product(x, y) {
            return Some(product);
        }
        let cross = self.graph.cross(x.components()?, y.components()?);
        let parts = self.parts_of_cross_product(x, y);
        let product = Matrix::with_elements(x.rows(), x.columns(), cross.to_vec());
        Some(self.with_parts(product, parts))
    }

    /// The sum of the squares of all elements.
    pub fn norm_squared(&mut self, matrix: &Matrix) -> Expression {
        if let Some(square) = self.unresolved_dot_product(matrix, matrix) {
            return square;
        }
        if let Some(square) = self.homogeneous_dot_product(matrix, matrix) {
            return square;
        }
        let squares: Vec<_> = matrix
            .elements()
            .iter()
            .map(|x| self.graph.square(*x))
            .collect();
        let sum = self
            .graph
            .sum(squares.into_iter().map(|square| (square, Rational::ONE)));
        self.or_in_other_frames(sum, matrix, matrix)
    }

    /// x · y by the elements, unless it is cheaper in another frame.
    fn or_in_other_frames(&mut self, product: Expression, x: &Matrix, y: &Matrix) -> Expression {
        let other = self.dot_product_of_parts(x, y);
        let cheaper =
            other.filter(|other| self.graph.cost(&[*other]) < self.graph.cost(&[product]));
        cheaper.unwrap_or(product)
    }

    /// The length of a vector: the root of the sum of the squares of all elements.
    pub fn norm(&mut self, matrix: &Matrix) -> Expression {
        let square = self.norm_squared(matrix);
        self.graph.square_root(square)
    }
}

impl Graph {
    /// The matrix of all products xᵢ yⱼ of the components of two vectors.
    pub fn outer_product(&mut self, x: &Matrix, y: &Matrix) -> Option<Matrix> {
        let (a, b) = (x.elements(), y.elements());
        let element = |i: usize, j: usize| self.multiply(a[i], b[j]);
        let vectors = x.is_vector() && y.is_vector();
        vectors.then(|| Matrix::from_function(a.len(), b.len(), element))
    }

    /// The matrix of v × of a vector v of three components: its product with u is v × u.
    pub fn cross_matrix(&mut self, vector: &Matrix) -> Option<Matrix> {
        let [x, y, z] = vector.components()?;
        let zero = self.zero();
        let [minus_x, minus_y, minus_z] = [x, y, z].map(|component| self.negate(component));
        let columns = [zero, z, minus_y, minus_z, zero, x, y, minus_x, zero];
        Some(Matrix::with_elements(3, 3, columns.to_vec()))
    }
}
