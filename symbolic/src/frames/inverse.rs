//! Trace, determinant and inverse of square matrices.
//!
//! The inverse is the adjugate over the determinant, both [expanded in minors](crate::matrix::determinant), and for
//! that reason limited in size. A larger matrix is eliminated numerically.

use crate::frames::factor::MatrixFactor;
use crate::frames::matrix::Matrix;
use crate::limits::MAX_DETERMINANT;
use crate::matrix::determinant::determinant;
use crate::{Expression, Geometry, Graph, Rational};

/// Why a matrix has no inverse.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum NoInverse {
    /// It is not square, or larger than can be inverted.
    Shape,
    /// Its determinant vanishes identically.
    Singular,
}

impl Geometry {
    /// The determinant of a square matrix of at most four rows.
    pub fn determinant(&mut self, matrix: &Matrix) -> Option<Expression> {
        if !is_small_square(matrix) {
            return None;
        }
        if is_product_of_rotations(matrix) {
            return Some(self.graph.one());
        }
        let all: Vec<usize> = (0..matrix.rows()).collect();
        let determinant = minor(&mut self.graph, matrix, &all, &all);
        Some(self.graph.reduced(determinant))
    }

    /// The inverse of a square matrix of at most four rows.
    ///
    /// # Errors
    ///
    /// If the matrix has another shape, or if its determinant vanishes identically.
    pub fn inverse(&mut self, matrix: &Matrix) -> Result<Matrix, NoInverse> {
        if is_product_of_rotations(matrix) {
            return Ok(matrix.transpose());
        }
        if let Some(inverse) = self.homogeneous_inverse(matrix) {
            return Ok(inverse);
        }
        let determinant = self.determinant(matrix).ok_or(NoInverse::Shape)?;
        if self.graph.vanishes(&[determinant]) {
            return Err(NoInverse::Singular);
        }
        let size = matrix.rows();
        let others = |left_out: usize| (0..size).filter(move |i| *i != left_out).collect();
        Ok(Matrix::from_function(size, size, |i, j| {
            let (rows, columns): (Vec<usize>, Vec<usize>) = (others(j), others(i));
            let minor = minor(&mut self.graph, matrix, &rows, &columns);
            let minor = self.graph.reduced(minor);
            let quotient = self.graph.divide(minor, determinant);
            if (i + j) % 2 == 0 {
                quotient
            } else {
                self.graph.negate(quotient)
            }
        }))
    }
}

impl Graph {
    /// The sum of the elements on the diagonal of a square matrix.
    pub fn trace(&mut self, matrix: &Matrix) -> Option<Expression> {
        let diagonal = matrix.diagonal()?;
        Some(self.sum(diagonal.elements().iter().map(|x| (*x, Rational::ONE))))
    }
}

/// Whether a matrix was computed as a product of rotations, whose inverse is its transpose.
fn is_product_of_rotations(matrix: &Matrix) -> bool {
    let factors = matrix.factors();
    factors.is_some_and(|factors| factors.iter().all(MatrixFactor::is_rotation))
}

/// Whether a matrix is square and small enough for a determinant in minors.
const fn is_small_square(matrix: &Matrix) -> bool {
    matrix.is_square() && matrix.rows() <= MAX_DETERMINANT
}

/// A minor of a matrix, expanded along the first of these columns.
fn minor(graph: &mut Graph, matrix: &Matrix, rows: &[usize], columns: &[usize]) -> Expression {
    // Along the first row of the transpose.
    determinant(graph, &|i, j| matrix.at(j, i), columns, rows)
}
