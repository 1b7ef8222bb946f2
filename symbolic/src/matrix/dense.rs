//! Matrices of expressions.
//!
//! What is known of them besides, as the factors of a product of rotations or the frames of a vector, the graph finds by their
//! [elements](crate::frames::vector_in_frames::KnownFrames).

use crate::Expression;

/// A matrix of expressions. A column vector is a matrix with one column.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Matrix {
    rows: usize,
    columns: usize,
    /// Column by column.
    elements: Vec<Expression>,
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

    /// The block of so many rows and columns that begins with the element in a row and a column, unless it is empty or
    /// larger than the matrix.
    #[must_use]
    pub fn block(
        &self,
        (row, column): (usize, usize),
        (rows, columns): (usize, usize),
    ) -> Option<Self> {
        let fits = |first: usize, count: usize, end: usize| {
            count > 0 && first.checked_add(count).is_some_and(|last| last <= end)
        };
        let fits = fits(row, rows, self.rows) && fits(column, columns, self.columns);
        fits.then(|| Self::from_function(rows, columns, |i, j| self.at(row + i, column + j)))
    }

    /// The matrix with rows and columns exchanged.
    #[must_use]
    pub fn transpose(&self) -> Self {
        Self::from_function(self.columns, self.rows, |i, j| self.at(j, i))
    }

    /// The elements on the diagonal of a square matrix, as a column vector.
    #[must_use]
    pub fn diagonal(&self) -> Option<Self> {
        let diagonal = || (0..self.rows).map(|i| self.at(i, i)).collect();
        self.is_square().then(|| Self::vector(diagonal()))
    }

    /// The three elements of a matrix that has three, and so only one row or column.
    pub(crate) fn components(&self) -> Option<[Expression; 3]> {
        self.elements().try_into().ok()
    }
}
