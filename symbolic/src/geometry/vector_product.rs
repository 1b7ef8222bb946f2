//! Products of vectors, which may be rows or columns, and what is made of them.

use crate::geometry::axis::Axis;
use crate::geometry::matrix::Matrix;
use crate::{Expression, Graph, Rational};

impl Graph {
    /// x · y of two rows or two columns of equal length.
    pub fn dot_product(&mut self, x: &Matrix, y: &Matrix) -> Option<Expression> {
        if !x.is_vector() || x.shape() != y.shape() {
            return None;
        }
        let pairs = x.elements().iter().copied();
        Some(self.sum_of_products(pairs.zip(y.elements().iter().copied())))
    }

    /// x × y of two rows or two columns of three components.
    pub fn cross_product(&mut self, x: &Matrix, y: &Matrix) -> Option<Matrix> {
        if x.shape() != y.shape() {
            return None;
        }
        let (a, b) = (x.components()?, y.components()?);
        let cross = Axis::ALL.map(|axis| {
            let [_, j, k] = axis.cycle();
            let ahead = self.multiply(a[j], b[k]);
            let behind = self.multiply(a[k], b[j]);
            self.subtract(ahead, behind)
        });
        Some(Matrix::with_elements(x.rows(), x.columns(), cross.to_vec()))
    }

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

    /// The sum of the squares of all elements.
    pub fn norm_squared(&mut self, matrix: &Matrix) -> Expression {
        let squares: Vec<_> = matrix.elements().iter().map(|x| self.square(*x)).collect();
        self.sum(squares.into_iter().map(|square| (square, Rational::ONE)))
    }

    /// The length of a vector: the root of the sum of the squares of all elements.
    pub fn norm(&mut self, matrix: &Matrix) -> Expression {
        let square = self.norm_squared(matrix);
        self.square_root(square)
    }
}

impl Matrix {
    /// The three elements of a matrix that has three, and so only one row or column.
    fn components(&self) -> Option<[Expression; 3]> {
        self.elements().try_into().ok()
    }
}
