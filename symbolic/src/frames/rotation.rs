//! Rotation matrices, and whether a matrix is one.

use crate::frames::axis::Axis;
use crate::frames::factor::{ElementaryRotation, MatrixFactor};
use crate::frames::matrix::Matrix;
use crate::identity::identity_testing::IdentityTest;
use crate::identity::residue;
use crate::limits::ROUNDED_CONSTANT;
use crate::{Expression, Geometry, Graph, Symbol};

/// Why a matrix is no rotation.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum NoRotation {
    /// It has not three rows and three columns.
    Shape,
    /// Its transpose times itself is not identically one: it changes lengths or angles.
    Deformation,
    /// It leaves lengths and angles, but its determinant is −1: it is a reflection.
    Reflection,
}

impl Geometry {
    /// The product R₁ R₂ … of elementary rotations (intrinsic Euler angles): it takes components in a frame that was
    /// rotated by the first angle about its first axis, then about its own new second axis, and so on, to
    /// components in the original frame. With the angles (φ, θ, ψ) about z, x, z it takes components in the body
    /// frame to components in the inertial frame.
    pub fn rotation(&mut self, sequence: &[(Axis, Expression)]) -> Matrix {
        let rotations = sequence.iter();
        let factors = rotations.map(|(axis, angle)| {
            MatrixFactor::Elementary(ElementaryRotation {
                axis: *axis,
                angle: *angle,
                reversed: false,
            })
        });
        let factors = self.merged(factors);
        self.product_of(factors)
    }

    /// The factors of a 3 × 3 matrix: the known ones, or itself.
    pub(crate) fn matrix_factors(&self, matrix: &Matrix) -> Option<Vec<MatrixFactor>> {
        if matrix.shape() != (3, 3) {
            return None;
        }
        if let Some(factors) = matrix.factors() {
            return Some(factors.to_vec());
        }
        let elements = matrix.elements().try_into().ok()?;
        Some(vec![if self.graph.is_rotation(&elements) {
            MatrixFactor::Rotation(elements)
        } else {
            MatrixFactor::General(elements)
        }])
    }

    /// Whether a matrix is a rotation, identically in all that it depends on: each factor of a product is, or all together are.
    ///
    /// # Errors
    ///
    /// If it is none. Constant factors with parameters are taken for rotations.
    pub fn check_rotation(&mut self, matrix: &Matrix) -> Result<(), NoRotation> {
        let factors = self.matrix_factors(matrix).ok_or(NoRotation::Shape)?;
        let others: Vec<_> = factors
            .iter()
            .filter(|factor| !factor.is_rotation())
            .map(|factor| factor.elements(&mut self.graph))
            .collect();
        let found = others
            .iter()
            .try_for_each(|x| self.graph.verify_rotation(x));
        if found.is_ok() || others.len() == 1 && factors.len() == 1 {
            return found;
        }
        let elements = matrix.elements().try_into();
        self.graph
            .verify_rotation(&elements.map_err(|_| NoRotation::Shape)?)
    }
}

impl Graph {
    /// Whether a matrix of nine elements is a rotation whatever the values of all symbols are, parameters
    /// among them.
    pub(crate) fn is_rotation(&self, elements: &[Expression; 9]) -> bool {
        IdentityTest::of(self, elements).holds(|point| {
            let values = point.evaluate(self, elements)?;
            Some(has_columns_of_a_rotation(&values, point.p()))
        })
    }

    /// Whether a matrix of nine elements is a rotation, identically in all that it depends on.
    ///
    /// Constant matrices that contain parameters are taken for rotations, since parameters may be such
    /// that they are; numerical ones must be rotations up to rounding. A matrix that is a rotation with
    /// the real roots and absolute values, though not for every choice of their signs, is accepted.
    pub(crate) fn verify_rotation(&mut self, elements: &[Expression; 9]) -> Result<(), NoRotation> {
        if !elements.iter().any(|x| self.contents(*x).varies()) {
            return self.verify_constant_rotation(elements);
        }
        let (residuals, volume) = self.orthogonality_residuals(elements);
        if !self.vanishes(&residuals) && !self.vanishes_at_real_points(&residuals) {
            return Err(NoRotation::Deformation);
        }
        if !self.vanishes(&[volume]) && !self.vanishes_at_real_points(&[volume]) {
            return Err(NoRotation::Reflection);
        }
        Ok(())
    }

    fn verify_constant_rotation(&mut self, elements: &[Expression; 9]) -> Result<(), NoRotation> {
        if !self.symbols(elements).is_empty() {
            return Ok(());
        }
        let (mut residuals, volume) = self.orthogonality_residuals(elements);
        residuals.push(volume);
        let values = self.evaluate(&residuals, |_: Symbol| f64::NAN);
        let small = |value: &f64| value.abs() < ROUNDED_CONSTANT;
        match values.split_last() {
            Some((_, residuals)) if !residuals.iter().all(small) => Err(NoRotation::Deformation),
            Some((volume, _)) if !small(volume) => Err(NoRotation::Reflection),
            _ => Ok(()),
        }
    }

    /// The elements of Aᵀ A − 1, and det A − 1.
    fn orthogonality_residuals(
        &mut self,
        elements: &[Expression; 9],
    ) -> (Vec<Expression>, Expression) {
        let matrix = Matrix::with_elements(3, 3, elements.to_vec());
        let mut residuals = Vec::new();
        for i in 0..3 {
            for j in i..3 {
                let pairs = (0..3).map(|k| (matrix.at(k, i), matrix.at(k, j)));
                let product = self.sum_of_products(pairs);
                let expected = if i == j { self.one() } else { self.zero() };
                residuals.push(self.subtract(product, expected));
            }
        }
        let pairs = Axis::ALL.map(|axis| {
            let [i, j, k] = axis.cycle();
            let ahead = self.multiply(matrix.at(j, 1), matrix.at(k, 2));
            let behind = self.multiply(matrix.at(k, 1), matrix.at(j, 2));
            (matrix.at(i, 0), self.subtract(ahead, behind))
        });
        let determinant = self.sum_of_products(pairs);
        let one = self.one();
        (residuals, self.subtract(determinant, one))
    }
}

/// Whether nine numbers, column by column, make a rotation modulo a prime: the columns are orthonormal, and
/// the last is the vector product of the others.
fn has_columns_of_a_rotation(values: &[u64], p: u64) -> bool {
    let product = |i: usize, j: usize| residue::multiply(values[i], values[j], p);
    let is_orthonormal = (0..3).all(|i| {
        (i..3).all(|j| {
            let products = (0..3).map(|k| product(3 * i + k, 3 * j + k));
            products.fold(0, |sum, x| residue::add(sum, x, p)) == u64::from(i == j)
        })
    });
    let is_right_handed = Axis::ALL.iter().all(|axis| {
        let [i, j, k] = axis.cycle();
        let behind = residue::negate(product(k, 3 + j), p);
        residue::add(product(j, 3 + k), behind, p) == values[6 + i]
    });
    is_orthonormal && is_right_handed
}
