//! Products of vectors, which may be rows or columns, and their norms.

use crate::frames::matrix::Matrix;
use crate::{Expression, Geometry, Graph};

impl Geometry {
    /// x · y of two rows or two columns of equal length.
    pub fn dot_product(&mut self, x: &Matrix, y: &Matrix) -> Option<Expression> {
        let fits = x.is_vector() && x.shape() == y.shape();
        fits.then(|| self.inner_product(x, y))
    }

    /// The sum of the products of elements in the same place, of matrices of one shape.
    fn inner_product(&mut self, x: &Matrix, y: &Matrix) -> Expression {
        let unresolved = self.unresolved_dot_product(x, y);
        if let Some(product) = unresolved.or_else(|| self.homogeneous_dot_product(x, y)) {
            return product;
        }
        let pairs = x.elements().iter().copied();
        let pairs = pairs.zip(y.elements().iter().copied());
        let product = self.graph.sum_of_products(pairs);
        let other = self.dot_product_of_parts(x, y);
        let cheaper =
            other.filter(|other| self.graph.cost(&[*other]) < self.graph.cost(&[product]));
        cheaper.unwrap_or(product)
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
        self.inner_product(matrix, matrix)
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
