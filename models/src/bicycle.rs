//! A bicycle without a rider's control.

use lagrangian::prelude::*;
use lagrangian::rigid_body::{BodyError, InertiaTensor};

/// Whipple's bicycle: a rear frame with a rigid rider, a front frame with the handlebar, and two wheels with sharp rims, which roll
/// on a plane without slipping (F. J. W. Whipple, *The stability of the motion of a bicycle*, Quart. J. Pure Appl. Math. **30** (1899)
/// 312–348).
///
/// The declaration is the nonlinear mechanism. It has 8 coordinates; the contact of the front wheel is a holonomic constraint, and
/// the coordinates are chosen so that the rear wheel touches the ground. Rolling adds two nonholonomic constraints for each wheel, so that
/// there are 3 degrees of freedom. Axes and parameters follow J. P. Meijaard, J. M. Papadopoulos, A. Ruina & A. L. Schwab,
/// *Linearized dynamics equations for the balance and steer of a bicycle: a benchmark and review*, Proc. R. Soc. A **463** (2007)
/// 1955–1982: x points forward, y to the right and z down, and the axes of both frames have these directions while the bicycle
/// stands upright and is not steered. At a speed v the wheels turn at −v/r.
///
/// ```
/// use lagrangian::prelude::*;
/// use lagrangian_models::Bicycle;
///
/// let bicycle = Bicycle::benchmark()?;
/// // It rolls straight on.
/// let straight = bicycle.straight(5.0);
/// let (gaps, slips) = bicycle.constraint_residuals(&straight);
/// assert!(gaps.amax() < 1e-15 && slips.amax() < 1e-15);
/// assert!(bicycle.accelerations(&straight).amax() < 1e-12);
/// // The ground carries the weight, of which the rear wheel has the larger part.
/// let forces = bicycle.multipliers(&straight);
/// assert!(forces[0] < 0.0 && -forces[0] < 0.5 * 94.0 * 9.81);
/// # Ok::<(), lagrangian::rigid_body::BodyError>(())
/// ```
#[derive(Lagrangian, Clone, Debug)]
#[lagrangian(
    taylor,
    reflect,
    c,
    coordinates(x, y, yaw, lean, pitch, steer, rear, front),
    define(
        upright = rotation_z(yaw) * rotation_x(lean),
        rear_axes = upright * rotation_y(pitch),
        front_axes = rear_axes * rotation_y(tilt) * rotation_z(steer) * rotation_y(-tilt),
        // Of the rear wheel the lowest point is below the centre in the plane of the frame.
        rear_arm = upright * [0.0, 0.0, rear_radius],
        rear_hub = [x, y, 0.0] - rear_arm,
        // The axis of steering meets the ground here, when the bicycle stands upright.
        crossing = rear_hub + rear_axes * [wheelbase + trail, 0.0, rear_radius],
        front_hub = crossing + front_axes * [-trail, 0.0, -front_radius],
        front_axle = front_axes * [0.0, 1.0, 0.0],
        incline = sqrt(1.0 - front_axle.z.powi(2)),
        front_arm = front_radius / incline * ([0.0, 0.0, 1.0] - front_axle.z * front_axle),
        w_rear = angular_velocity(rear_axes) + [0.0, dot(rear), 0.0],
        w_front = angular_velocity(front_axes) + [0.0, dot(front), 0.0],
        rear_slip = dot(rear_hub) + (rear_axes * w_rear).cross(rear_arm),
        front_slip = dot(front_hub) + (front_axes * w_front).cross(front_arm),
    ),
    body(
        rear_frame = (rear_axes, rear_hub),
        front_frame = (front_axes, crossing),
    ),
    kinetic = 0.5 * rear_mass * dot(rear_hub).norm_squared()
        + 0.5 * (rear_across * (w_rear.x.powi(2) + w_rear.z.powi(2)) + rear_axial * w_rear.y.powi(2)),
    kinetic = 0.5 * front_mass * dot(front_hub).norm_squared()
        + 0.5 * (front_across * (w_front.x.powi(2) + w_front.z.powi(2)) + front_axial * w_front.y.powi(2)),
    potential = -g * (rear_mass * rear_hub.z + front_mass * front_hub.z),
    gravity = [0.0, 0.0, g],
    force(lean = lean_torque, steer = steer_torque, rear = drive),
    constraint(ground = front_hub.z + front_radius * incline),
    nonholonomic(
        rear_rolling = [rear_slip.x, rear_slip.y],
        front_rolling = [front_slip.x, front_slip.y],
    ),
)]
pub struct Bicycle {
    /// The rear frame with the rider, in axes whose origin is the centre of the rear wheel.
    pub rear_frame: RigidBody,
    /// The front frame with the handlebar, in axes whose origin is the point at which the axis of steering meets the ground.
    pub front_frame: RigidBody,
    /// The mass of the rear wheel in kg.
    pub rear_mass: f64,
    /// The radius of the rear wheel in m.
    pub rear_radius: f64,
    /// The moment of inertia of the rear wheel about its axis in kg m².
    pub rear_axial: f64,
    /// The moment of inertia of the rear wheel about a diameter.
    pub rear_across: f64,
    /// The mass of the front wheel.
    pub front_mass: f64,
    /// The radius of the front wheel.
    pub front_radius: f64,
    /// The moment of inertia of the front wheel about its axis.
    pub front_axial: f64,
    /// The moment of inertia of the front wheel about a diameter.
    pub front_across: f64,
    /// The distance of the points of contact, when the bicycle stands upright.
    pub wheelbase: f64,
    /// How far the axis of steering meets the ground in front of the front wheel's contact.
    pub trail: f64,
    /// The inclination of the axis of steering from the vertical, backwards, in rad.
    pub tilt: f64,
    /// The acceleration of gravity in m/s².
    pub g: f64,
    /// A torque that leans the bicycle, in N m.
    #[lagrangian(input)]
    pub lean_torque: f64,
    /// The torque between the frames.
    #[lagrangian(input)]
    pub steer_torque: f64,
    /// The torque about the axis of the rear wheel; what drives the bicycle is negative.
    #[lagrangian(input)]
    pub drive: f64,
}

impl Bicycle {
    /// The benchmark bicycle of Meijaard et al. (2007), table 1.
    ///
    /// # Errors
    ///
    /// None: its bodies have inertia.
    pub fn benchmark() -> Result<Self, BodyError> {
        let (wheelbase, trail, tilt) = (1.02, 0.08, core::f64::consts::PI / 10.0);
        let (rear_radius, front_radius) = (0.3, 0.35);
        let body = |mass, from: [f64; 2], at: [f64; 2], [xx, yy, zz, xz]: [f64; 4]| {
            let center = Vector3::new(at[0] - from[0], 0.0, at[1] - from[1]);
            let inertia = Matrix3::new(xx, 0.0, xz, 0.0, yy, 0.0, xz, 0.0, zz);
            RigidBody::new(mass, center, InertiaTensor::from_matrix(&inertia)?)
        };
        Ok(Self {
            rear_frame: body(
                85.0,
                [0.0, -rear_radius],
                [0.3, -0.9],
                [9.2, 11.0, 2.8, 2.4],
            )?,
            front_frame: body(
                4.0,
                [wheelbase + trail, 0.0],
                [0.9, -0.7],
                [0.05892, 0.06, 0.00708, -0.00756],
            )?,
            rear_mass: 2.0,
            rear_radius,
            rear_axial: 0.12,
            rear_across: 0.0603,
            front_mass: 3.0,
            front_radius,
            front_axial: 0.28,
            front_across: 0.1405,
            wheelbase,
            trail,
            tilt,
            g: 9.81,
            lean_torque: 0.0,
            steer_torque: 0.0,
            drive: 0.0,
        })
    }

    /// The state in which the bicycle rolls upright and straight on along x at this speed.
    #[must_use]
    pub fn straight(&self, speed: f64) -> State<f64, 8> {
        let mut state = State::new(0.0, [0.0; 8], [0.0; 8]);
        state.v[Self::X] = speed;
        state.v[Self::REAR] = -speed / self.rear_radius;
        state.v[Self::FRONT] = -speed / self.front_radius;
        state
    }
}
