//! What the emitted code names, and nobody else.

pub use nalgebra::{SMatrix, SVector};

use crate::Scalar;

/// A field's type, as far as scalars can be made from it.
pub trait Parameter {
    /// The value on a scalar.
    fn on<S: Scalar>(self) -> S;
}

impl Parameter for f64 {
    #[inline]
    fn on<S: Scalar>(self) -> S {
        S::from_f64(self)
    }
}

impl Parameter for f32 {
    #[inline]
    fn on<S: Scalar>(self) -> S {
        S::from_f64(self.into())
    }
}

/// The value of a field on the scalar that is being computed with.
#[inline]
pub fn parameter<S: Scalar>(field: impl Parameter) -> S {
    field.on()
}
