//! An arm of three joints.

use lagrangian::prelude::*;

/// A robot's arm: a column that turns by q₀ about the vertical, and two links that turn by q₁ and q₂ about horizontal axes, at which
/// motors act. With q = 0 both links are stretched along x; positive angles lower them.
///
/// Each link is a body in axes whose origin is its joint, and that lie along those of space while q = 0.
///
/// ```
/// use lagrangian::prelude::*;
/// use lagrangian_models::Arm;
///
/// let link = RigidBody::particle(3.0, Vector3::new(0.3, 0.0, 0.0))?;
/// let model = Arm {
///     column: SymmetricBody::new(20.0, 0.25, 0.5, 0.1)?,
///     upper: link,
///     lower: link,
///     height: 0.5,
///     length: 0.6,
///     g: 9.81,
///     torque: Vector3::zeros(),
/// };
/// // What the motors hold while the arm rests, the upper link level and the lower one hanging by 0.4 rad.
/// let rest = State::new(0.0, [0.7, 0.0, 0.4], [0.0; 3]);
/// let lower = -9.81 * 3.0 * 0.3 * 0.4_f64.cos();
/// let upper = lower - 9.81 * 3.0 * (0.3 + 0.6);
/// let held = Vector3::new(0.0, upper, lower);
/// assert!((model.with_inputs(held).inverse_dynamics(&rest, &Vector3::zeros())).norm() < 1e-13);
/// # Ok::<(), lagrangian::rigid_body::BodyError>(())
/// ```
#[derive(Lagrangian, Clone, Debug)]
#[lagrangian(
    taylor,
    reflect,
    coordinates(q[3]),
    define(
        turned = rotation_z(q[0]),
        raised = turned * rotation_y(q[1]),
        bent = raised * rotation_y(q[2]),
        shoulder = [0.0, 0.0, height],
        elbow = shoulder + raised * [length, 0.0, 0.0],
    ),
    body(
        column = (turned, [0.0, 0.0, 0.0]),
        upper = (raised, shoulder),
        lower = (bent, elbow),
    ),
    gravity = [0.0, 0.0, -g],
    force(q[i] = torque[i] for i in 0..3),
    output(elbow = elbow),
)]
pub struct Arm {
    /// The column.
    pub column: SymmetricBody,
    /// The link between shoulder and elbow.
    pub upper: RigidBody,
    /// The link behind the elbow, with what it holds.
    pub lower: RigidBody,
    /// The height of the shoulder in m.
    pub height: f64,
    /// The distance from the shoulder to the elbow in m.
    pub length: f64,
    /// The acceleration of gravity in m/s².
    pub g: f64,
    /// The torques of the motors in N m, which a controller sets.
    #[lagrangian(input)]
    pub torque: Vector3<f64>,
}
