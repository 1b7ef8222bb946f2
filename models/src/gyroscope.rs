//! A rotor in two gimbals.

use lagrangian::prelude::*;

/// A gyroscope in gimbals: the outer gimbal turns by φ about the vertical, the inner one in it by θ about a horizontal axis, and the
/// rotor in that by ψ about its own. All three axes meet in the origin of all bodies. A weight is a part of the inner gimbal.
///
/// Other than that of a top, its motion is singular nowhere, since the gimbals have inertia.
///
/// ```
/// use lagrangian::prelude::*;
/// use lagrangian::rigid_body::{InertiaTensor, SteadyPrecession};
/// use lagrangian_models::Gyroscope;
///
/// let ring = |scale: f64| {
///     let inertia = InertiaTensor::principal([1e-5, 2e-5, 1.2e-5]).scaled(scale);
///     RigidBody::new(0.02 * scale, Vector3::zeros(), inertia)
/// };
/// let weight = RigidBody::particle(0.03, Vector3::new(0.0, 0.0, 0.06))?;
/// let inner = ring(1.0)?.plus(&weight);
/// let rotor = SymmetricBody::new(0.5, 0.0, 2e-4, 4e-4)?;
/// let model = Gyroscope { outer: ring(2.0)?, inner, rotor, g: 9.81 };
///
/// // Steady precession (4.11): I is that across the axis less that of the inner gimbal about it.
/// let [_, across, along] = inner.inertia_about(&Vector3::zeros()).moments();
/// let (theta, spin) = (1.1_f64, 150.0);
/// let slope = -0.03 * 9.81 * 0.06 * theta.sin();
/// let transverse = across + rotor.transverse_moment() - along;
/// let precession = SteadyPrecession::of_top(transverse, 4e-4, spin, theta, slope);
/// let SteadyPrecession::Two { slow, .. } = precession else { unreachable!() };
/// let steady = State::new(0.0, [0.0, theta, 0.0], [slow, 0.0, spin - slow * theta.cos()]);
/// assert!(model.accelerations(&steady).norm() < 1e-10);
/// # Ok::<(), lagrangian::rigid_body::BodyError>(())
/// ```
#[derive(Lagrangian, Clone, Debug)]
#[lagrangian(
    taylor,
    reflect,
    coordinates(phi, theta, psi),
    define(
        outer_axes = rotation_z(phi),
        inner_axes = outer_axes * rotation_x(theta),
        rotor_axes = inner_axes * rotation_z(psi),
        center = [0.0, 0.0, 0.0],
    ),
    body(
        outer = (outer_axes, center),
        inner = (inner_axes, center),
        rotor = (rotor_axes, center),
    ),
    gravity = [0.0, 0.0, -g],
    output(axis = inner_axes * [0.0, 0.0, 1.0]),
)]
pub struct Gyroscope {
    /// The outer gimbal, which turns about its z axis.
    pub outer: RigidBody,
    /// The inner gimbal, with its bearings in the outer one along x, and those of the rotor along z.
    pub inner: RigidBody,
    /// The rotor.
    pub rotor: SymmetricBody,
    /// The acceleration of gravity in m/s².
    pub g: f64,
}
