//! The errors that are allowed in the components of a state.

use crate::scalar::Scalar;

/// The tolerances of the error of a step, from which the error that is allowed in each component follows
/// ([`Dynamics::allowed_error`](crate::Dynamics::allowed_error)).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ErrorTolerance<S = f64> {
    /// The tolerance relative to the size of a component.
    pub relative: f64,
    /// The tolerance of a coordinate, in its units.
    pub absolute: f64,
    /// That of a velocity is `absolute` times this, 1 over the time in which the motion goes on.
    pub rate: S,
}

impl<S> ErrorTolerance<S> {
    /// The tolerance of derivative parts relative to the tangent vector of which they are components.
    pub(crate) fn of_derivatives(&self) -> f64 {
        if self.relative > 0.0 {
            self.relative
        } else {
            self.absolute.min(1.0)
        }
    }
}

impl<S: Scalar> ErrorTolerance<S> {
    /// The error that is allowed for a coordinate of a size: absolute + relative · size.
    #[inline]
    #[must_use]
    pub fn of_coordinate(&self, size: S) -> S {
        S::from_f64(self.absolute) + S::from_f64(self.relative) * size
    }

    /// The error that is allowed for a velocity of a size: absolute · rate + relative · size.
    #[inline]
    #[must_use]
    pub fn of_velocity(&self, size: S) -> S {
        S::from_f64(self.absolute) * self.rate + S::from_f64(self.relative) * size
    }
}
