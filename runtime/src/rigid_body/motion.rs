//! The velocity and the acceleration of the points of a rigid body (1.3)–(1.5).

use nalgebra::Vector3;

use crate::scalar::Scalar;

/// The motion of a rigid body at an instant: the motion of one of its points, usually the centre of gravity, and its
/// rotation.
///
/// All vectors are components in one set of axes, either of space or of the body. Velocities and accelerations refer to
/// an inertial frame, even if their components are along the axes of the body.
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
    /// The position of the reference point, which is the centre of gravity in (1.3).
    pub position: Vector3<S>,
    /// The velocity of the reference point.
    pub velocity: Vector3<S>,
    /// The acceleration of the reference point.
    pub acceleration: Vector3<S>,
    /// The angular velocity **ω** of the body, in rad over time.
    pub angular_velocity: Vector3<S>,
    /// The angular acceleration **α** = d**ω**/dt.
    pub angular_acceleration: Vector3<S>,
}

impl<S: Scalar> RigidMotion<S> {
    /// Returns the motion of a body at rest whose reference point is at the origin.
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

    /// Returns the position of the point of the body that is at `relative` from the reference point (1.3).
    #[must_use]
    pub fn position_of(&self, relative: &Vector3<S>) -> Vector3<S> {
        self.position + relative
    }

    /// Returns the velocity **v** + **ω** × **r** of the point at `relative` from the reference point (1.4).
    #[must_use]
    pub fn velocity_of(&self, relative: &Vector3<S>) -> Vector3<S> {
        self.velocity + self.angular_velocity.cross(relative)
    }

    /// Returns the acceleration **a** + **α** × **r** + **ω** × (**ω** × **r**) of the point at `relative` from the
    /// reference point (1.5).
    #[must_use]
    pub fn acceleration_of(&self, relative: &Vector3<S>) -> Vector3<S> {
        let centripetal = self
            .angular_velocity
            .cross(&self.angular_velocity.cross(relative));
        self.acceleration + self.angular_acceleration.cross(relative) + centripetal
    }

    /// Returns this motion with another point of the body as the reference point.
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
