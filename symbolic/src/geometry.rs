//! Vectors and matrices of expressions, and rotations.

pub(crate) mod axis;
pub(crate) mod matrix;
pub(crate) mod factor;
pub(crate) mod turned_vector;
pub(crate) mod combination;
pub(crate) mod matrix_product;
pub(crate) mod vector_product;
pub(crate) mod determinant;
pub(crate) mod reduction;
pub(crate) mod rotation;
pub(crate) mod angular_velocity;
