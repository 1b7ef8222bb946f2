//! A stone that turns one way only.

use lagrangian::prelude::*;

/// A rattleback, or celt: an ellipsoid that rolls on a plane without slipping, and whose principal axes of inertia are not those of its
/// surface. Spun one way it begins to rattle and turns back (T. R. Kane & D. A. Levinson, Realistic mathematical modeling of the
/// rattleback, 1982; A. Garcia & M. Hubbard, Spin reversal of the rattleback: theory and experiment, 1988).
///
/// The position (x, y) is that of the ellipsoid's centre, its height follows from the contact with the plane, and yaw, pitch and roll
/// are 0 where it lies on its flat side, its semi-axes along x, y and z. The body's axes have their origin in the ellipsoid's
/// centre. The contact is the point of the surface with the normal −e₃: with n = rᵀ e₃ it is −D² n/|D n|, D = diag(a, b, c).
///
/// ```
/// use lagrangian::nalgebra::Vector3;
/// use lagrangian::prelude::*;
/// use lagrangian::rigid_body::InertiaTensor;
/// use lagrangian_models::Rattleback;
///
/// let inertia = Matrix3::new(2e-4, -2e-5, 0.0, -2e-5, 1.6e-3, 0.0, 0.0, 0.0, 1.7e-3);
/// let center = Vector3::new(0.0, 0.0, -0.01);
/// let stone = RigidBody::new(1.0, center, InertiaTensor::from_matrix(&inertia)?)?;
/// let model = Rattleback { stone, semi: Vector3::new(0.2, 0.03, 0.02), g: 9.81 };
///
/// // Rolling: any rates of the angles, and the velocity of the centre that belongs to them.
/// let guess = State::new(0.0, [0.0, 0.0, 0.3, 0.1, -0.2], [0.0, 0.0, -5.0, 0.4, 0.7]);
/// let start = model.assemble(guess).hold_velocities(2..5).solve()?.state;
/// assert!(model.outputs(&start).slip.norm() < 1e-15);
///
/// // The plane pushes at the contact, and its force is all that changes the angular momentum about the centre of gravity.
/// let at = |t: f64| Problem::new(&model, start).solve(t, Taylor::new()).map(|end| model.outputs(&end));
/// let h = 1e-5;
/// let change = (at(h)?.angular_momentum - at(-h)?.angular_momentum) / (2.0 * h);
/// let now = model.outputs(&start);
/// assert!((change - now.arm.cross(&now.contact_force)).norm() < 1e-5 * change.norm());
///
/// // Spun the wrong way, it turns back.
/// let tilted = State::new(0.0, [0.0, 0.0, 0.0, 0.0087, 0.0087], [0.0, 0.0, -5.0, 0.0, 0.0]);
/// let start = model.assemble(tilted).hold_velocities(2..5).solve()?.state;
/// let end = Problem::new(&model, start).solve(6.0, Taylor::new())?;
/// assert!(end.v[Rattleback::YAW] > 1.0);
/// assert!((model.energy(&end) / model.energy(&start) - 1.0).abs() < 1e-12);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Lagrangian, Clone, Debug)]
#[lagrangian(
    taylor,
    reflect,
    coordinates(x, y, yaw, pitch, roll),
    define(
        r = rotation_zyx(yaw, pitch, roll),
        normal = r.transpose() * [0.0, 0.0, 1.0],
        scaled = semi.component_mul(normal),
        height = scaled.norm(),
        center = [x, y, height],
        contact = r * (-semi.component_mul(scaled) / height),
        slip = dot(center) + angular_velocity_inertial(r).cross(contact),
        gravity_center = center + r * stone.center,
    ),
    body(stone = (r, center)),
    gravity = [0.0, 0.0, -g],
    nonholonomic(rolling = [slip.x, slip.y]),
    output(
        contact = center + contact,
        slip = slip,
        arm = contact - r * stone.center,
        contact_force = stone.mass * (dot(dot(gravity_center)) + [0.0, 0.0, g]),
        angular_momentum = r * (stone.inertia * angular_velocity(r)),
    ),
)]
pub struct Rattleback {
    /// The stone in axes along those of its ellipsoid, with the origin in the ellipsoid's centre.
    pub stone: RigidBody,
    /// The semi-axes of the ellipsoid in m.
    pub semi: Vector3<f64>,
    /// The acceleration of gravity in m/s².
    pub g: f64,
}
