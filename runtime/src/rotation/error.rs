//! What is no rotation, and where angles have no rates.

use core::fmt;

use super::euler_sequence::EulerSequence;
use crate::error_debug::debug_by_message;
use crate::number_format::Readable;

/// Why there is no such rotation, or no such rate.
#[derive(Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum RotationError {
    /// The angles are at a pole: two axes of the sequence are parallel, and an angular velocity about their common normal
    /// has no rates.
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
        /// The indices of two columns, or the same twice, from 0.
        columns: [usize; 2],
        /// Their scalar product, which should be 0, or 1 if they are the same.
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

impl fmt::Display for RotationError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Self::Singular {
                sequence,
                angle,
                determinant,
            } => write!(
                f,
                "the {sequence} angles are singular where the second angle is {}: det E is {}; use another sequence \
                 there, or a quaternion",
                Readable(angle),
                Readable(determinant)
            ),
            Self::NotOrthonormal {
                columns: [first, second],
                product,
            } if first == second => write!(
                f,
                "the matrix is no rotation: the square of the length of column {first} is {}",
                Readable(product)
            ),
            Self::NotOrthonormal {
                columns: [first, second],
                product,
            } => write!(
                f,
                "the matrix is no rotation: the scalar product of columns {first} and {second} is {}",
                Readable(product)
            ),
            Self::Reflection { determinant } => write!(
                f,
                "the matrix is a reflection, its determinant is {}: the axes are left-handed",
                Readable(determinant)
            ),
            Self::NoOrientation { norm } => write!(
                f,
                "a quaternion of norm {} has no orientation",
                Readable(norm)
            ),
        }
    }
}

debug_by_message!(RotationError);

impl core::error::Error for RotationError {}
