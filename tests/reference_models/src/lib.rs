//! Writes the models that the tests evaluate: in goes the reference data, out comes Rust.

mod expression;
mod declaration;
mod random_lagrangian;
mod trajectory;

pub use random_lagrangian::source as random_lagrangians;
pub use trajectory::source as trajectories;
