//! Trace, determinant and inverse of square matrices.
//!
//! Determinants by expansion in minors (Gentleman and Johnson, Analysis of algorithms, a case study: determinants
//! of matrices with polynomial entries, 1976): sums of products, without a division, and for that reason limited in
//! size. A larger matrix is eliminated numerically.

use crate::decision::identity_test::IdentityTest;
use crate::geometry::factor::MatrixFactor;
use crate::geometry::matrix::Matrix;
use crate::{Expression, Graph, Rational};

/// Determinants of matrices with more rows are not expanded.
pub const LARGEST_DETERMINANT: usize = 4;

/// Why a matrix has no inverse.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum NoInverse {
    /// It is not square, or larger than can be inverted.
    Shape,
    /// Its determinant vanishes identically.
    Singular,
}

impl Graph {
    /// The sum of the elements on the diagonal of a square matrix.
    pub fn trace(&mut self, matrix: &Matrix) -> Option<Expression> {
        let diagonal = matrix.diagonal()?;
        Some(self.sum(diagonal.elements().iter().map(|x| (*x, Rational::ONE))))
    }

    /// The determinant of a square matrix of at most four rows.
    pub fn determinant(&mut self, matrix: &Matrix) -> Option<Expression> {
        if !is_small_square(matrix) {
            return None;
        }
        if is_product_of_rotations(matrix) {
            return Some(self.one());
        }
        let all: Vec<usize> = (0..matrix.rows()).collect();
        let determinant = self.minor(matrix, &all, &all);
        Some(self.reduced(determinant))
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
        let determinant = self.determinant(matrix).ok_or(NoInverse::Shape)?;
        if self.vanishes(&[determinant]) {
            return Err(NoInverse::Singular);
        }
        let size = matrix.rows();
        let others = |left_out: usize| (0..size).filter(move |i| *i != left_out).collect();
        Ok(Matrix::from_function(size, size, |i, j| {
            let (rows, columns): (Vec<usize>, Vec<usize>) = (others(j), others(i));
            let minor = self.minor(matrix, &rows, &columns);
            let minor = self.reduced(minor);
            let quotient = self.divide(minor, determinant);
            if (i + j) % 2 == 0 {
                quotient
            } else {
                self.negate(quotient)
            }
        }))
    }

    /// Whether all expressions vanish identically.
    pub(crate) fn vanishes(&self, expressions: &[Expression]) -> bool {
        IdentityTest::of(self, expressions).holds(|point| {
            let values = point.evaluate(self, expressions)?;
            Some(values.iter().all(|value| *value == 0))
        })
    }

    /// The minor of some rows and as many columns of a matrix, expanded along the first of these columns.
    fn minor(&mut self, matrix: &Matrix, rows: &[usize], columns: &[usize]) -> Expression {
        let [column, others @ ..] = columns else {
            return self.one();
        };
        let mut terms = Vec::new();
        for (position, row) in rows.iter().enumerate() {
            let element = matrix.at(*row, *column);
            if self.is_zero(element) {
                continue;
            }
            let rest: Vec<usize> = rows.iter().copied().filter(|i| i != row).collect();
            let minor = self.minor(matrix, &rest, others);
            let sign = if position % 2 == 0 { 1 } else { -1 };
            terms.push((self.multiply(element, minor), Rational::integer(sign)));
        }
        self.sum(terms)
    }
}

/// Whether a matrix is square and small enough for a determinant in minors.
const fn is_small_square(matrix: &Matrix) -> bool {
    matrix.is_square() && matrix.rows() <= LARGEST_DETERMINANT
}

/// Whether a matrix is a product of rotations, whose inverse is its transpose.
fn is_product_of_rotations(matrix: &Matrix) -> bool {
    let factors = matrix.known_factors();
    factors.is_some_and(|factors| factors.iter().all(MatrixFactor::is_rotation))
}
