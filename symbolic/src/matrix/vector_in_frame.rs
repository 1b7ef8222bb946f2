//! Vectors known by their components in a frame.

use crate::Expression;
use crate::matrix::factor::MatrixFactor;

/// A vector R v, known by its components v in the frame of R.
#[derive(Clone, Debug)]
pub(crate) struct VectorInFrame {
    /// R, as the product of these rotations.
    pub(crate) rotation: Vec<MatrixFactor>,
    /// v.
    pub(crate) vector: [Expression; 3],
}
