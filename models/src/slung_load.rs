//! A quadrotor that carries a load on a cable.

use lagrangian::prelude::*;

/// A quadrotor with a load on a cable, which is taken as a rod without mass from the quadrotor's centre of gravity: its position, its
/// yaw, pitch and roll, and two angles of the cable, which hangs at a = b = 0. The cable turns by a about y, and then by b about its own
/// x axis, and is singular where cos b = 0. The rotors together give a thrust along the quadrotor's z axis, and a torque along its axes.
///
/// The load obeys (M + m)(r̈ + g e₃) = (n·F − M l |ṅ|²) n, with the thrust F in space and the direction n of the cable
/// (K. Sreenath, T. Lee & V. Kumar, Geometric control and differential flatness of a quadrotor UAV with a cable-suspended load,
/// 2013).
///
/// ```
/// use lagrangian::prelude::*;
/// use lagrangian_models::SlungLoad;
///
/// let (mass, load, l, g) = (0.8, 0.3, 0.9, 9.81);
/// let body = PrincipalBody::new(mass, [4e-3, 5e-3, 8e-3])?;
/// let model = SlungLoad { body, load, l, g, thrust: 13.0, torque: Vector3::new(0.01, -0.02, 0.005) };
/// let state = State::new(
///     0.0,
///     [0.1, 0.2, 0.3, 0.4, -0.2, 0.3, 0.5, -0.6],
///     [1.0, -0.5, 0.2, 0.3, 0.7, -0.4, 0.9, 1.2],
/// );
/// let found = model.outputs(&state);
/// let n = found.direction;
/// let up = Vector3::z() * g;
/// let tension = n.dot(&(13.0 * found.axis)) - mass * l * found.direction_rate.norm_squared();
/// assert!(((mass + load) * (found.load_acceleration + up) - tension * n).norm() < 1e-13);
/// // The cable does not turn the quadrotor: Euler's equations (3.5)–(3.7) of a free body under the torque.
/// let (w, rate) = (found.angular_velocity, found.angular_acceleration);
/// let inertia = body.inertia();
/// assert!((inertia * rate + w.cross(&(inertia * w)) - model.torque).norm() < 1e-15);
/// # Ok::<(), lagrangian::rigid_body::BodyError>(())
/// ```
#[derive(Lagrangian, Clone, Debug)]
#[lagrangian(
    taylor,
    reflect,
    coordinates(p: Vector3, yaw, pitch, roll, a, b),
    define(
        axes = rotation_zyx(yaw, pitch, roll),
        w = angular_velocity(axes),
        cable = rotation_y(a) * rotation_x(b) * [0.0, 0.0, -1.0],
        end = p + l * cable,
    ),
    body(body = (axes, p)),
    kinetic = 0.5 * load * dot(end).norm_squared(),
    potential = load * g * end.z,
    gravity = [0.0, 0.0, -g],
    force(p = thrust * (axes * [0.0, 0.0, 1.0]), w = torque),
    output(
        load = end,
        load_acceleration = dot(dot(end)),
        direction = cable,
        direction_rate = dot(cable),
        axis = axes * [0.0, 0.0, 1.0],
        angular_velocity = w,
        angular_acceleration = dot(w),
    ),
)]
pub struct SlungLoad {
    /// The quadrotor, along its principal axes.
    pub body: PrincipalBody,
    /// The mass of the load in kg.
    pub load: f64,
    /// The length of the cable in m.
    pub l: f64,
    /// The acceleration of gravity in m/s².
    pub g: f64,
    /// The thrust of the rotors in N, which a controller sets.
    #[lagrangian(input)]
    pub thrust: f64,
    /// The torque of the rotors in N m, which a controller sets.
    #[lagrangian(input)]
    pub torque: Vector3<f64>,
}
