//! Vectors and matrices of expressions, rotations, and vectors in frames.

pub(crate) mod axis;
pub(crate) mod matrix;
pub(crate) mod factor;
pub(crate) mod vector_in_frame;
pub(crate) mod combination;
pub(crate) mod matrix_product;
pub(crate) mod vector_product;
pub(crate) mod determinant;
pub(crate) mod reduction;
pub(crate) mod rotation;
pub(crate) mod angular_velocity;
