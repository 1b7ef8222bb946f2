//! The errors of rotations and of the rates of angles.

use super::euler_sequence::EulerSequence;
use crate::error_messages::error_messages;
use crate::number_format::Readable;

/// The reason why a rotation or a rate does not exist.
#[derive(Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum RotationError {
    /// The angles are at a pole: two axes of the sequence are parallel, and no rates of the angles belong to an angular
    /// velocity about their common normal.
    Singular {
        /// The sequence of the angles.
        sequence: EulerSequence,
        /// The second angle.
        angle: f64,
        /// The determinant of the matrix E of (4.4), ∓sin θ or ±cos θ.
        determinant: f64,
    },
    /// The columns of a matrix are not orthonormal.
    NotOrthonormal {
        /// The indices of two columns, counted from 0, which may be equal.
        columns: [usize; 2],
        /// The scalar product of the columns, which should be 0, or 1 if they are equal.
        product: f64,
    },
    /// A matrix is a reflection: its columns are orthonormal and left-handed.
    Reflection {
        /// Its determinant.
        determinant: f64,
    },
    /// The norm of a quaternion is zero or not finite.
    NoOrientation {
        /// The norm.
        norm: f64,
    },
}

error_messages! { RotationError:
    Self::Singular { sequence, angle, determinant } =>
        "the {sequence} angles are singular where the second angle is {}: det E is {}; use another sequence \
         there, or a quaternion",
        Readable(angle), Readable(determinant);
    Self::NotOrthonormal { columns: [first, second], product } if first == second =>
        "the matrix is no rotation: the square of the length of column {first} is {}",
        Readable(product);
    Self::NotOrthonormal { columns: [first, second], product } =>
        "the matrix is no rotation: the scalar product of columns {first} and {second} is {}",
        Readable(product);
    Self::Reflection { determinant } =>
        "the matrix is a reflection, its determinant is {}: the axes are left-handed",
        Readable(determinant);
    Self::NoOrientation { norm } => "a quaternion of norm {} has no orientation", Readable(norm);
}
