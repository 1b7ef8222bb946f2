//! Matrices of expressions, and how they were computed.

use crate::Expression;
use crate::frames::factor::MatrixFactor;
use crate::frames::frame_tree::Frame;

/// A matrix of expressions. A column vector is a matrix with one column.
///
/// Matrices are equal if their elements are, whatever their structure.
#[derive(Clone, Debug)]
pub struct Matrix {
    rows: usize,
    columns: usize,
    /// Column by column.
    elements: Vec<Expression>,
    pub(crate) structure: Structure,
}

/// How a matrix was computed, as far as that makes what is computed from it cheaper.
#[derive(Clone, Debug)]
pub(crate) enum Structure {
    /// By its elements alone.
    General,
    /// As the product of these factors, which have three rows and columns.
    Product(Vec<MatrixFactor>),
    /// As the sum Σ R v of vectors in frames, along inertial axes.
    Sum(Vec<Part>),
    /// As the homogeneous matrix of a rotation R and a place p.
    Homogeneous(Box<[Matrix; 2]>),
    /// As homogeneous coordinates, of which the first three are this vector.
    Coordinates(Box<Matrix>),
}

/// A vector R v, by the frame of R and its components v there.
pub(crate) type Part = (Frame, [Expression; 3]);

impl PartialEq for Matrix {
    fn eq(&self, other: &Self) -> bool {
        (self.shape(), self.elements()) == (other.shape(), other.elements())
    }
}

impl Eq for Matrix {}

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
            structure: Structure::General,
        }
    }

    /// The matrix with this structure.
    pub(crate) fn with_structure(self, structure: Structure) -> Self {
        Self { structure, ..self }
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
        let part = match (&self.structure, (row, column), (rows, columns)) {
            (Structure::Homogeneous(blocks), (0, 0), (3, 3)) => Some(&blocks[0]),
            (Structure::Homogeneous(blocks), (0, 3), (3, 1)) => Some(&blocks[1]),
            (Structure::Coordinates(vector), (0, 0), (3, 1)) => Some(&**vector),
            _ => None,
        };
        if let Some(part) = part {
            return Some(part.clone());
        }
        fits.then(|| Self::from_function(rows, columns, |i, j| self.at(row + i, column + j)))
    }

    /// The matrix with rows and columns exchanged.
    #[must_use]
    pub fn transpose(&self) -> Self {
        let structure = match &self.structure {
            Structure::Product(factors) => {
                let factors = factors.iter().rev().map(MatrixFactor::transpose);
                Structure::Product(factors.collect())
            }
            sum @ Structure::Sum(_) => sum.clone(),
            _ => Structure::General,
        };
        Self::from_function(self.columns, self.rows, |i, j| self.at(j, i)).with_structure(structure)
    }

    /// The matrix of the values of a function of each element.
    pub(crate) fn map(&self, function: impl FnMut(Expression) -> Expression) -> Self {
        let elements = self.elements.iter().copied().map(function);
        Self::with_elements(self.rows, self.columns, elements.collect())
    }

    /// The elements on the diagonal of a square matrix, as a column vector.
    #[must_use]
    pub fn diagonal(&self) -> Option<Self> {
        let diagonal = || (0..self.rows).map(|i| self.at(i, i)).collect();
        self.is_square().then(|| Self::vector(diagonal()))
    }

    /// The factors of a matrix that was computed as a product, or whose transpose was.
    pub(crate) fn factors(&self) -> Option<&[MatrixFactor]> {
        match &self.structure {
            Structure::Product(factors) => Some(factors),
            _ => None,
        }
    }

    /// The vectors in frames of which this one is the sum; none where it is known by its components alone.
    pub(crate) fn parts(&self) -> &[Part] {
        match &self.structure {
            Structure::Sum(parts) => parts,
            _ => &[],
        }
    }

    /// The three elements of a matrix that has three, and so only one row or column.
    pub(crate) fn components(&self) -> Option<[Expression; 3]> {
        self.elements().try_into().ok()
    }
}
