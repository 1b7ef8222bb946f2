//! Error tolerances for the components of a state.

use crate::scalar::Scalar;

/// The error tolerances of a step, which determine the allowed error of each component
/// ([`Dynamics::allowed_error`](crate::Dynamics::allowed_error)).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ErrorTolerance<S = f64> {
    /// The tolerance relative to the size of a component.
    pub relative: f64,
    /// The absolute tolerance of a coordinate, in its units.
    pub absolute: f64,
    /// The ratio of a velocity's absolute tolerance to `absolute`: 1 over the time scale of the motion.
    pub rate: S,
}

impl<S> ErrorTolerance<S> {
    /// Returns the tolerance of derivative parts, relative to the tangent vector that they belong to.
    pub(crate) fn of_derivatives(&self) -> f64 {
        if self.relative > 0.0 {
            self.relative
        } else {
            self.absolute.min(1.0)
        }
    }
}

impl<S: Scalar> ErrorTolerance<S> {
    /// Returns the allowed error of a coordinate of a given size: absolute + relative · size.
    #[inline]
    #[must_use]
    pub fn of_coordinate(&self, size: S) -> S {
        S::from_f64(self.absolute) + S::from_f64(self.relative) * size
    }

    /// Returns the allowed error of a velocity of a given size: absolute · rate + relative · size.
    #[inline]
    #[must_use]
    pub fn of_velocity(&self, size: S) -> S {
        S::from_f64(self.absolute) * self.rate + S::from_f64(self.relative) * size
    }
}
