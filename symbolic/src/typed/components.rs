//! The components of a value, or why it has none.

use crate::{Expression, Matrix, NoRotation};

/// The components of a value of a [typed graph](crate::TypedGraph).
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum Components {
    /// A number.
    Scalar(Expression),
    /// A vector, which is a matrix of one column, or a matrix.
    Array(Matrix),
    /// A sum without terms: the zero of whatever it is added to.
    EmptySum,
}

/// Why an operation has no value.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum NoValue {
    /// Arguments should be something else: this.
    Arguments(&'static str),
    /// The array would have too many components.
    Size,
    /// A matrix has no inverse: its determinant vanishes identically.
    Singular,
    /// A matrix has no angular velocity.
    NoRotation(NoRotation),
    /// Shapes that do not fit, or an argument that has no value.
    Shapes,
}

impl Components {
    /// All of them, column by column.
    #[must_use]
    pub fn elements(&self) -> &[Expression] {
        match self {
            Self::Scalar(expression) => core::slice::from_ref(expression),
            Self::Array(matrix) => matrix.elements(),
            Self::EmptySum => &[],
        }
    }

    /// The matrix, of a vector or a matrix.
    #[must_use]
    pub const fn array(&self) -> Option<&Matrix> {
        match self {
            Self::Array(matrix) => Some(matrix),
            Self::Scalar(_) | Self::EmptySum => None,
        }
    }
}
