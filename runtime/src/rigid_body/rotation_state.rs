//! Orientation and angular velocity: the state of a rotating body.

use nalgebra::{UnitQuaternion, Vector3, Vector4};

use crate::linalg::{
    ErrorTolerance, LaneStates, VectorSpace, lanes_by_fields, operations_by_fields,
};
use crate::rotation::{components, normalized};
use crate::scalar::{Lanes, Scalar};

/// The orientation of a body, as a unit quaternion, and its angular velocity in axes of the body.
///
/// The quaternion rotates components in axes of the body to components in axes of space. An integration of
/// [`EulerEquations`](super::EulerEquations) keeps its norm at 1 up to rounding; [`orientation`](Self::orientation)
/// divides by the norm. In the derivative of a state, the fields hold the rates of the quaternion and the angular
/// acceleration.
///
/// The components are w, x, y, z of the quaternion, then ω₁, ω₂, ω₃.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct RotationState<S: Scalar = f64> {
    /// The components w, x, y, z of the quaternion.
    pub quaternion: Vector4<S>,
    /// The angular velocity **ω** in axes of the body, in rad over time.
    pub angular_velocity: Vector3<S>,
}

impl<S: Scalar> RotationState<S> {
    /// Creates the state of a body with an orientation and an angular velocity in axes of the body.
    #[must_use]
    pub fn new(orientation: &UnitQuaternion<S>, angular_velocity: Vector3<S>) -> Self {
        Self {
            quaternion: components(orientation).into(),
            angular_velocity,
        }
    }

    /// Creates the state of a body whose axes coincide with the axes of space.
    #[must_use]
    pub fn aligned(angular_velocity: Vector3<S>) -> Self {
        let [zero, one] = [S::zero(), S::one()];
        Self {
            quaternion: Vector4::from([one, zero, zero, zero]),
            angular_velocity,
        }
    }

    /// Returns the orientation.
    #[must_use]
    pub fn orientation(&self) -> UnitQuaternion<S> {
        normalized(self.quaternion.into())
    }

    /// Returns the components in axes of space of a vector given in axes of the body.
    #[must_use]
    pub fn to_space(&self, in_body: &Vector3<S>) -> Vector3<S> {
        crate::rotation::rotation_of(&self.orientation()).matrix() * in_body
    }

    /// Returns the components in axes of the body of a vector given in axes of space.
    #[must_use]
    pub fn to_body(&self, in_space: &Vector3<S>) -> Vector3<S> {
        crate::rotation::rotation_of(&self.orientation())
            .matrix()
            .tr_mul(in_space)
    }
}

/// Returns the Euclidean norm.
fn norm<'a, S: Scalar>(components: impl Iterator<Item = &'a S>) -> S {
    components.fold(S::zero(), |sum, x| sum + *x * *x).sqrt()
}

impl<S: Scalar> VectorSpace<S> for RotationState<S> {
    operations_by_fields! { quaternion, angular_velocity }

    #[inline]
    fn components(&self) -> impl Iterator<Item = S> + '_ {
        self.quaternion
            .iter()
            .chain(self.angular_velocity.iter())
            .copied()
    }

    /// The components of a unit quaternion have the size 1; the components of the angular velocity have the size of the
    /// vector.
    #[inline]
    fn allowed_error(&self, tolerance: &ErrorTolerance<S>) -> Self {
        let of_quaternion = tolerance.of_coordinate(S::one());
        let of_velocity = tolerance.of_velocity(norm(self.angular_velocity.iter()));
        Self {
            quaternion: self.quaternion.map(|_| of_quaternion),
            angular_velocity: self.angular_velocity.map(|_| of_velocity),
        }
    }

    /// Returns the larger of the rate of rotation and the square root of its rate of change.
    fn rate(&self, _: &Self) -> Option<S> {
        let turning = norm(self.quaternion.iter());
        let changing = norm(self.angular_velocity.iter()).sqrt();
        Some((turning + turning).max(changing))
    }
}

lanes_by_fields! {
    [] RotationState<Lanes<L>> => RotationState<f64> { quaternion, angular_velocity }
}
