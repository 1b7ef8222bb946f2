//! A Stewart platform, driven along a circle.

use lagrangian::prelude::*;

/// A Stewart platform: six legs that change their lengths carry a platform (Stewart, *A platform with six degrees of freedom*,
/// 1965). Thirteen bodies move.
///
/// The lower part of each leg, a cylinder, hangs from a universal joint at `base[k]`: it turns by `a[k]` about the horizontal
/// axis y, and then by `b[k]` about its own axis x. The upper part, a rod, slides in it; its end, at the distance `s[k]` from
/// the universal joint, is a spherical joint at the point `top[k]` of the platform. The six loops are closed by the constraint
/// `joint`, and the drives of the legs, `drive`, move the level platform along a circle of this radius. With a radius of 0 it
/// is held at rest.
///
/// The reaction of `drive` is the force in N with which each drive pushes its rod out of its cylinder, and the reaction of `joint` the
/// force of the platform on the rod. The output `carried` is the sum of the forces of the rods on the platform.
///
/// While all angles are zero, the axes of all bodies are parallel to the inertial axes, so that legs are along z. The axes of a
/// cylinder have their origin in its universal joint, and the axes of a rod in its spherical joint.
///
/// ```
/// use lagrangian::prelude::*;
/// use lagrangian_models::StewartPlatform;
///
/// let model = StewartPlatform {
///     platform: SymmetricBody::new(40.0, 0.0, 2.0, 4.0)?,
///     cylinder: [SymmetricBody::new(3.0, 0.3, 0.35, 0.01)?; 6],
///     rod: [SymmetricBody::new(1.5, -0.3, 0.18, 0.002)?; 6],
///     base: StewartPlatform::hexagon(1.0, 0.2),
///     top: StewartPlatform::hexagon(0.6, 0.847_197_551_196_597_7),
///     height: 1.0,
///     radius: 0.0,
///     omega: 1.0,
///     g: 9.81,
/// };
/// let start = model.assemble(model.guess(0.0)).solve()?.state;
/// // At rest, the forces of the joints on the platform carry its weight.
/// let weight = 40.0 * 9.81;
/// let outputs = model.outputs(&start);
/// assert!((outputs.carried - Vector3::new(0.0, 0.0, weight)).norm() < 1e-12 * weight);
/// // All drives push alike.
/// assert!(outputs.force.iter().all(|force| (force - outputs.force[0]).abs() < 1e-12 * weight));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Lagrangian, Clone, Debug)]
#[lagrangian(
    taylor,
    reflect,
    c,
    coordinates(p: Vector3, yaw, pitch, roll, a[6], b[6], s[6]),
    define(
        turn = rotation_zyx(yaw, pitch, roll),
        leg[k] = rotation_y(a[k]) * rotation_x(b[k]) for k in 0..6,
        end[k] = base[k] + s[k] * (leg[k] * [0.0, 0.0, 1.0]) for k in 0..6,
        goal = [radius * cos(omega * t), radius * sin(omega * t), height],
    ),
    body(
        platform = (turn, p),
        cylinder[k] = (leg[k], base[k]) for k in 0..6,
        rod[k] = (leg[k], end[k]) for k in 0..6,
    ),
    gravity = [0.0, 0.0, -g],
    constraint(
        joint[k] = end[k] - p - turn * top[k] for k in 0..6,
        drive[k] = s[k] - (goal + top[k] - base[k]).norm() for k in 0..6,
    ),
    output(
        carried = -reaction(joint[0]) - reaction(joint[1]) - reaction(joint[2]) - reaction(joint[3]) - reaction(joint[4])
            - reaction(joint[5]),
        force = [
            reaction(drive[0]), reaction(drive[1]), reaction(drive[2]), reaction(drive[3]), reaction(drive[4]), reaction(drive[5]),
        ],
    ),
)]
pub struct StewartPlatform {
    /// The platform, with its load.
    pub platform: SymmetricBody,
    /// The lower parts of the legs.
    pub cylinder: [SymmetricBody; 6],
    /// The upper parts of the legs.
    pub rod: [SymmetricBody; 6],
    /// The universal joints in space.
    pub base: [Vector3<f64>; 6],
    /// The spherical joints in the axes of the platform.
    pub top: [Vector3<f64>; 6],
    /// The height of the platform in m.
    pub height: f64,
    /// The radius of its circle in m.
    pub radius: f64,
    /// The angular frequency of its motion in rad/s.
    pub omega: f64,
    /// Gravity in m/s².
    pub g: f64,
}

impl StewartPlatform {
    /// Six points of a circle about the origin, in pairs beside the directions of 0°, 120° and 240°, by this angle in rad.
    #[must_use]
    pub fn hexagon(radius: f64, angle: f64) -> [Vector3<f64>; 6] {
        core::array::from_fn(|k| {
            let (pair, side) = (k.div_ceil(2) % 3, if k % 2 == 0 { 1.0 } else { -1.0 });
            let third = 2.0 * core::f64::consts::FRAC_PI_3;
            let direction = [0.0, third, 2.0 * third][pair] + side * angle;
            Vector3::new(radius * direction.cos(), radius * direction.sin(), 0.0)
        })
    }

    /// A state at this time, at rest, with the platform on its way and legs from joint to joint.
    #[must_use]
    pub fn guess(&self, t: f64) -> State<f64, 24> {
        let (sine, cosine) = (self.omega * t).sin_cos();
        let center = Vector3::new(self.radius * cosine, self.radius * sine, self.height);
        let mut state = State::new(t, [0.0; 24], [0.0; 24]);
        for (i, x) in center.iter().enumerate() {
            state.q[Self::P[i]] = *x;
        }
        for (k, (base, top)) in self.base.iter().zip(&self.top).enumerate() {
            let leg = center + top - base;
            state.q[Self::A[k]] = leg.x.atan2(leg.z);
            state.q[Self::B[k]] = -leg.y.atan2(leg.x.hypot(leg.z));
            state.q[Self::S[k]] = leg.norm();
        }
        state
    }
}
