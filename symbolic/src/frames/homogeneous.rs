//! Homogeneous matrices [R p; 0 1] and coordinates (x, w) of points, w = 1, and of free vectors, w = 0 (Denavit and
//! Hartenberg, A kinematic notation for lower-pair mechanisms based on matrices, 1955; Paul, Robot Manipulators, 1981).
//!
//! A product is made block by block, so that rotations have their factors and places are vectors: R R′, R p′ + p.

use crate::frames::factor::MatrixFactor;
use crate::frames::matrix::{Matrix, Structure};
use crate::{Expression, Geometry, Graph, Rational};

impl Geometry {
    /// A homogeneous matrix times another one, or times homogeneous coordinates.
    pub(crate) fn homogeneous_product(&mut self, left: &Matrix, right: &Matrix) -> Option<Matrix> {
        let [first, origin] = self.graph.blocks(left)?;
        if right.shape() == (4, 1) {
            let (vector, last) = split(right)?;
            let turned = self.matrix_product(&first, &vector)?;
            let moved = self.matrix_scaled(&origin, last);
            let sum = self.matrix_sum(&[(&turned, Rational::ONE), (&moved, Rational::ONE)])?;
            return Some(extended(&sum, last));
        }
        let [second, place] = self.graph.blocks(right)?;
        let rotation = self.matrix_product(&first, &second)?;
        let turned = self.matrix_product(&first, &place)?;
        let place = self.matrix_sum(&[(&origin, Rational::ONE), (&turned, Rational::ONE)])?;
        self.graph.homogeneous(&rotation, &place)
    }

    /// The inverse [Rᵀ −Rᵀ p; 0 1] of a homogeneous matrix whose R is a product of rotations.
    pub(crate) fn homogeneous_inverse(&mut self, matrix: &Matrix) -> Option<Matrix> {
        let [rotation, place] = self.graph.blocks(matrix)?;
        let factors = self.matrix_factors(&rotation)?;
        if !factors.iter().all(MatrixFactor::is_rotation) {
            return None;
        }
        let back = rotation.transpose();
        let place = self.matrix_product(&back, &place)?;
        let opposite = self.graph.constant(&Rational::MINUS_ONE);
        let place = self.matrix_scaled(&place, opposite);
        self.graph.homogeneous(&back, &place)
    }

    /// Σ fᵢ xᵢ of homogeneous coordinates, one of which is a vector that is resolved last.
    pub(crate) fn homogeneous_sum(&mut self, terms: &[(&Matrix, Expression)]) -> Option<Matrix> {
        let mut vectors = Vec::with_capacity(terms.len());
        let mut last = Vec::with_capacity(terms.len());
        for (x, factor) in terms {
            let (vector, w) = self.unresolved_coordinates(x)?;
            vectors.push((vector, *factor));
            last.push((*factor, w));
        }
        let vectors: Vec<_> = vectors.iter().map(|(x, factor)| (x, *factor)).collect();
        let vector = self.unresolved_sum(&vectors)?;
        let last = self.graph.sum_of_products(last);
        Some(extended(&vector, last))
    }

    /// The time derivative of homogeneous coordinates of a vector that is resolved last.
    pub(crate) fn homogeneous_rate(&mut self, column: &Matrix) -> Option<Matrix> {
        let (vector, last) = self.unresolved_coordinates(column)?;
        if self.graph.contents(last).varies() {
            return None;
        }
        let rate = self.unresolved_rate(&vector)?;
        Some(extended(&rate, self.graph.zero()))
    }

    /// x · y of homogeneous coordinates of vectors that are resolved last.
    pub(crate) fn homogeneous_dot_product(&mut self, x: &Matrix, y: &Matrix) -> Option<Expression> {
        let [(x, v), (y, w)] = [
            self.unresolved_coordinates(x)?,
            self.unresolved_coordinates(y)?,
        ];
        let product = self.unresolved_dot_product(&x, &y)?;
        let last = self.graph.multiply(v, w);
        Some(self.graph.add(product, last))
    }

    /// The vector and the last of four coordinates, where vectors are resolved last.
    fn unresolved_coordinates(&self, column: &Matrix) -> Option<(Matrix, Expression)> {
        self.unresolved.as_ref()?;
        split(column)
    }
}

impl Graph {
    /// The homogeneous matrix of a matrix of three rows and a place, unless they have other shapes.
    pub fn homogeneous(&mut self, rotation: &Matrix, place: &Matrix) -> Option<Matrix> {
        if rotation.shape() != (3, 3) || place.shape() != (3, 1) {
            return None;
        }
        let elements = Matrix::from_function(4, 4, |i, j| match (i, j) {
            (3, 3) => self.one(),
            (3, _) => self.zero(),
            (_, 3) => place.at(i, 0),
            _ => rotation.at(i, j),
        });
        let blocks = [rotation, place].map(Matrix::clone);
        Some(elements.with_structure(Structure::Homogeneous(Box::new(blocks))))
    }

    /// The blocks R and p of a matrix of four rows whose last one is 0 0 0 1.
    fn blocks(&self, matrix: &Matrix) -> Option<[Matrix; 2]> {
        let (zero, one) = (self.zero(), self.one());
        let last = [zero, zero, zero, one];
        if matrix.shape() != (4, 4) || (0..4).any(|j| matrix.at(3, j) != last[j]) {
            return None;
        }
        Some([matrix.block((0, 0), (3, 3))?, matrix.block((0, 3), (3, 1))?])
    }
}

/// The first three of four coordinates, and the last.
fn split(column: &Matrix) -> Option<(Matrix, Expression)> {
    let is_column = column.shape() == (4, 1);
    let vector = column.block((0, 0), (3, 1)).filter(|_| is_column)?;
    Some((vector, column.at(3, 0)))
}

/// A vector with one more component.
pub(crate) fn extended(vector: &Matrix, last: Expression) -> Matrix {
    let mut elements = vector.elements().to_vec();
    elements.push(last);
    let extended = Matrix::vector(elements);
    if vector.shape() == (3, 1) {
        return extended.with_structure(Structure::Coordinates(Box::new(vector.clone())));
    }
    extended
}
