//! A pendulum at the end of an arm that turns.

use lagrangian::prelude::*;

/// Furuta's pendulum: a motor turns an arm by α about the vertical, and a rod swings by θ about the arm, hanging at θ = 0
/// (K. Furuta, M. Yamakita & S. Kobayashi, 1992).
///
/// The arm lies along the x axis of its body, and the axes of the rod have their origin at the joint, with z upwards while it hangs.
///
/// ```
/// use lagrangian::nalgebra::{Matrix2, Vector2};
/// use lagrangian::prelude::*;
/// use lagrangian_models::FurutaPendulum;
///
/// let (m, l, length) = (0.2, 0.3, 0.25);
/// let model = FurutaPendulum {
///     arm: PrincipalBody::new(0.4, [1e-4, 3e-3, 3e-3])?,
///     rod: RigidBody::particle(m, Vector3::new(0.0, 0.0, -l))?,
///     length,
///     g: 9.81,
///     torque: 0.1,
/// };
/// let state = State::new(0.0, [0.4, 0.9], [1.1, -0.7]);
/// let [alpha, beta, gamma] = [3e-3 + m * length * length, m * l * l, m * length * l];
/// let (s, c) = state.q[1].sin_cos();
/// let mass = Matrix2::new(alpha + beta * s * s, gamma * c, gamma * c, beta);
/// let forcing = Vector2::new(
///     0.1 - 2.0 * beta * s * c * 1.1 * -0.7 + gamma * s * 0.49,
///     beta * s * c * 1.21 - m * 9.81 * l * s,
/// );
/// assert!((mass * model.accelerations(&state) - forcing).norm() < 1e-14);
/// # Ok::<(), lagrangian::rigid_body::BodyError>(())
/// ```
#[derive(Lagrangian, Clone, Debug)]
#[lagrangian(
    taylor,
    reflect,
    c,
    coordinates(alpha, theta),
    define(turned = rotation_z(alpha)),
    body(
        arm = (turned, [0.0, 0.0, 0.0]),
        rod = (turned * rotation_x(theta), turned * [length, 0.0, 0.0]),
    ),
    gravity = [0.0, 0.0, -g],
    force(alpha = torque),
)]
pub struct FurutaPendulum {
    /// The arm, whose centre of gravity is on the axis of the motor.
    pub arm: PrincipalBody,
    /// The rod in axes whose origin is its joint.
    pub rod: RigidBody,
    /// The distance of the joint from the axis of the motor in m.
    pub length: f64,
    /// The acceleration of gravity in m/s².
    pub g: f64,
    /// The torque of the motor in N m, which a controller sets.
    #[lagrangian(input)]
    pub torque: f64,
}
