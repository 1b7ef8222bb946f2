//! The velocity and the acceleration of the points of a rigid body (1.3)–(1.5).

use nalgebra::Vector3;

use crate::scalar::Scalar;

/// How a rigid body moves at an instant: the motion of one of its points, mostly the centre of gravity, and its
/// rotation.
///
/// All vectors are components in the same axes, which may be those of space or of the body; velocities and accelerations
/// are those seen from an inertial frame, also where their components are along the axes of the body.
///
/// ```
/// use lagrangian::rigid_body::RigidMotion;
/// use lagrangian::nalgebra::Vector3;
///
/// // A wheel of radius 0.5 that rolls along x without slipping, faster and faster: its lowest point rests, (1.4).
/// let wheel = RigidMotion {
///     position: Vector3::new(0.0, 0.0, 0.5),
///     velocity: Vector3::new(2.0, 0.0, 0.0),
///     acceleration: Vector3::new(1.0, 0.0, 0.0),
///     angular_velocity: Vector3::new(0.0, 4.0, 0.0),
///     angular_acceleration: Vector3::new(0.0, 2.0, 0.0),
/// };
/// let lowest = Vector3::new(0.0, 0.0, -0.5);
/// assert_eq!(wheel.velocity_of(&lowest), Vector3::zeros());
/// // Its acceleration is towards the centre, ω² r, (1.5).
/// assert_eq!(wheel.acceleration_of(&lowest), Vector3::new(0.0, 0.0, 8.0));
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RigidMotion<S: Scalar = f64> {
    /// The position of the point, in (1.3) that of the centre of gravity.
    pub position: Vector3<S>,
    /// Its velocity.
    pub velocity: Vector3<S>,
    /// Its acceleration.
    pub acceleration: Vector3<S>,
    /// The angular velocity **ω** of the body, in rad over time.
    pub angular_velocity: Vector3<S>,
    /// The angular acceleration **α** = d**ω**/dt.
    pub angular_acceleration: Vector3<S>,
}

impl<S: Scalar> RigidMotion<S> {
    /// A body at rest whose reference point is at the origin.
    #[must_use]
    pub fn rest() -> Self {
        let zero = Vector3::zeros();
        Self {
            position: zero,
            velocity: zero,
            acceleration: zero,
            angular_velocity: zero,
            angular_acceleration: zero,
        }
    }

    /// The position of the point of the body that is at `relative` from the reference point (1.3).
    #[must_use]
    pub fn position_of(&self, relative: &Vector3<S>) -> Vector3<S> {
        self.position + relative
    }

    /// The velocity of that point, **v** + **ω** × **r** (1.4).
    #[must_use]
    pub fn velocity_of(&self, relative: &Vector3<S>) -> Vector3<S> {
        self.velocity + self.angular_velocity.cross(relative)
    }

    /// The acceleration of that point, **a** + **α** × **r** + **ω** × (**ω** × **r**) (1.5).
    #[must_use]
    pub fn acceleration_of(&self, relative: &Vector3<S>) -> Vector3<S> {
        let centripetal = self
            .angular_velocity
            .cross(&self.angular_velocity.cross(relative));
        self.acceleration + self.angular_acceleration.cross(relative) + centripetal
    }

    /// The same motion, described by that of another point of the body.
    #[must_use]
    pub fn at(&self, relative: &Vector3<S>) -> Self {
        Self {
            position: self.position_of(relative),
            velocity: self.velocity_of(relative),
            acceleration: self.acceleration_of(relative),
            ..*self
        }
    }
}
