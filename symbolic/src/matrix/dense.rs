//! Matrices of expressions.
//!
//! A 3 × 3 matrix that was computed as a product remembers its factors: operations that are cheap for each of them,
//! such as the rotation of a vector or the angular velocity, need not use the elements of the product. A vector
//! remembers the frames in which it is known: what no rotation changes, such as its length, is then computed in the
//! cheapest of them. What is remembered does not count for equality: two matrices are equal if their elements are.

use crate::Expression;
use crate::matrix::factor::MatrixFactor;
use crate::matrix::vector_in_frame::VectorInFrame;

/// A matrix of expressions. A column vector is a matrix with one column.
#[derive(Clone, Debug)]
pub struct Matrix {
    rows: usize,
    columns: usize,
    /// Column by column.
    elements: Vec<Expression>,
    /// The factors of which this is the product, if they are known.
    factors: Option<Vec<MatrixFactor>>,
    /// The same of the upper left block of a homogeneous matrix of four rows.
    factors_of_block: Option<Vec<MatrixFactor>>,
    /// The vectors in frames of which this vector of three components is the sum; empty if unknown.
    parts: Vec<VectorInFrame>,
}

impl Matrix {
    /// The matrix of these elements, column by column, unless their number is another one or zero.
    #[must_use]
    pub fn new(rows: usize, columns: usize, elements: Vec<Expression>) -> Option<Self> {
        let fits = rows.checked_mul(columns) == Some(elements.len()) && !elements.is_empty();
        fits.then(|| Self::with_elements(rows, columns, elements))
    }

    /// A column vector.
    #[must_use]
    pub fn vector(elements: Vec<Expression>) -> Self {
        Self::with_elements(elements.len(), 1, elements)
    }

    /// The matrix of elements of which there are as many as there should be.
    pub(crate) const fn with_elements(
        rows: usize,
        columns: usize,
        elements: Vec<Expression>,
    ) -> Self {
        Self {
            rows,
            columns,
            elements,
            factors: None,
            factors_of_block: None,
            parts: Vec::new(),
        }
    }

    /// The matrix with an element for each row and column.
    pub(crate) fn from_function(
        rows: usize,
        columns: usize,
        mut element: impl FnMut(usize, usize) -> Expression,
    ) -> Self {
        let mut elements = Vec::with_capacity(rows * columns);
        for column in 0..columns {
            for row in 0..rows {
                elements.push(element(row, column));
            }
        }
        Self::with_elements(rows, columns, elements)
    }

    /// The same matrix, which remembers that it is the product of these factors.
    pub(crate) fn remembering(self, factors: Vec<MatrixFactor>) -> Self {
        Self {
            factors: Some(factors),
            ..self
        }
    }

    /// The same matrix, which remembers that its block of three rows and columns is the product of these factors.
    pub(crate) fn remembering_block(self, factors: Vec<MatrixFactor>) -> Self {
        Self {
            factors_of_block: Some(factors),
            ..self
        }
    }

    /// The same vector, which remembers that it is the sum of these vectors in frames.
    pub(crate) fn with_parts(self, parts: Vec<VectorInFrame>) -> Self {
        Self { parts, ..self }
    }

    /// How many rows there are.
    #[must_use]
    pub const fn rows(&self) -> usize {
        self.rows
    }

    /// How many columns there are.
    #[must_use]
    pub const fn columns(&self) -> usize {
        self.columns
    }

    /// The numbers of rows and of columns.
    #[must_use]
    pub const fn shape(&self) -> (usize, usize) {
        (self.rows, self.columns)
    }

    /// Whether there is only one row or only one column.
    #[must_use]
    pub const fn is_vector(&self) -> bool {
        self.rows == 1 || self.columns == 1
    }

    /// Whether there are as many rows as columns.
    #[must_use]
    pub const fn is_square(&self) -> bool {
        self.rows == self.columns
    }

    /// The element in a row and a column, counted from zero.
    #[must_use]
    pub fn get(&self, row: usize, column: usize) -> Option<Expression> {
        (row < self.rows && column < self.columns).then(|| self.at(row, column))
    }

    /// The element in a row and a column that exist.
    pub(crate) fn at(&self, row: usize, column: usize) -> Expression {
        self.elements[column * self.rows + row]
    }

    /// All elements, column by column.
    #[must_use]
    pub fn elements(&self) -> &[Expression] {
        &self.elements
    }

    /// A row, as a matrix with one row.
    #[must_use]
    pub fn row(&self, row: usize) -> Option<Self> {
        (row < self.rows).then(|| Self::from_function(1, self.columns, |_, j| self.at(row, j)))
    }

    /// A column, as a matrix with one column.
    #[must_use]
    pub fn column(&self, column: usize) -> Option<Self> {
        (column < self.columns)
            .then(|| Self::from_function(self.rows, 1, |i, _| self.at(i, column)))
    }

    /// The matrix with rows and columns exchanged.
    #[must_use]
    pub fn transpose(&self) -> Self {
        let factors = self.factors.as_ref();
        Self {
            factors: factors
                .map(|factors| factors.iter().rev().map(MatrixFactor::transpose).collect()),
            parts: self.parts.clone(),
            ..Self::from_function(self.columns, self.rows, |i, j| self.at(j, i))
        }
    }

    /// The elements on the diagonal of a square matrix, as a column vector.
    #[must_use]
    pub fn diagonal(&self) -> Option<Self> {
        let diagonal = || (0..self.rows).map(|i| self.at(i, i)).collect();
        self.is_square().then(|| Self::vector(diagonal()))
    }

    /// The remembered factors.
    pub(crate) fn known_factors(&self) -> Option<&[MatrixFactor]> {
        self.factors.as_deref()
    }

    /// The remembered factors of the block of three rows and columns.
    pub(crate) fn known_factors_of_block(&self) -> Option<&[MatrixFactor]> {
        self.factors_of_block.as_deref()
    }

    /// The remembered vectors in frames of which this is the sum.
    pub(crate) fn known_parts(&self) -> &[VectorInFrame] {
        &self.parts
    }

    /// The three elements of a matrix that has three, and so only one row or column.
    pub(crate) fn components(&self) -> Option<[Expression; 3]> {
        self.elements().try_into().ok()
    }
}

impl PartialEq for Matrix {
    fn eq(&self, other: &Self) -> bool {
        self.shape() == other.shape() && self.elements == other.elements
    }
}

impl Eq for Matrix {}
