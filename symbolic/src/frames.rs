//! Vector algebra: products, rotations, angular velocities, and vectors in frames.

pub(crate) mod axis;
pub(crate) mod factor;
pub(crate) mod frame_tree;
pub(crate) mod matrix;
pub(crate) mod vector_in_frames;
pub(crate) mod geometry;
pub(crate) mod elementwise;
pub(crate) mod merging;
pub(crate) mod matrix_product;
pub(crate) mod vector_product;
pub(crate) mod resolution;
pub(crate) mod recognition;
pub(crate) mod unresolved;
pub(crate) mod homogeneous;
pub(crate) mod declared_velocities;
pub(crate) mod inverse;
pub(crate) mod rotation;
pub(crate) mod angular_velocity;
