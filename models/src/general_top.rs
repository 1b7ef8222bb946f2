//! Any body under its weight, with a fixed point.

use lagrangian::prelude::*;

/// A heavy body of any shape with a fixed point, the origin of its axes, in precession φ, nutation θ and spin ψ:
/// T = ½ ωᵀ\[`I_O`\]ω (4.2), V = m g z of its centre of gravity.
///
/// The angles are singular where sin θ = 0. Through there, `lagrangian::rigid_body::EulerEquations` with the moment of the weight
/// has a quaternion.
///
/// ```
/// use lagrangian::nalgebra::Vector3;
/// use lagrangian::prelude::*;
/// use lagrangian::rigid_body::{ConstantForce, EulerEquations, RotationState, Solid};
/// use lagrangian::rotation::{EulerAngles, EulerSequence};
/// use lagrangian_models::GeneralTop;
///
/// let brick = Solid::cuboid(0.1, 0.2, 0.3)?.with_density(1800.0)?;
/// let body = brick.moved(Vector3::new(0.05, 0.1, 0.15));
/// let top = GeneralTop { body, g: 9.81 };
/// let start = State::new(0.0, [0.3, 1.0, 0.4], [0.5, -0.4, 9.0]);
/// let end = Problem::new(&top, start).solve(0.5, Taylor::new())?;
///
/// // Euler's equations about the fixed point (3.5)–(3.7).
/// let angles = |state: &State<f64, 3>| EulerAngles::new(EulerSequence::Zxz, state.q.into());
/// let force = Vector3::new(0.0, 0.0, -9.81 * body.mass());
/// let weight = ConstantForce { point: body.center(), force };
/// let equations = EulerEquations::about_fixed_point(&body, &Vector3::zeros())?.with_moment(weight);
/// let state = RotationState::new(&angles(&start).quaternion(), angles(&start).angular_velocity(&start.v));
/// let expected = Problem::new(&equations, At { t: 0.0, x: state }).solve(0.5, Taylor::new())?;
/// let omega = angles(&end).angular_velocity(&end.v);
/// assert!((omega - expected.angular_velocity).norm() < 1e-9);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Lagrangian, Clone, Debug)]
#[lagrangian(
    taylor,
    reflect,
    c,
    coordinates(phi, theta, psi),
    define(r = rotation_zxz(phi, theta, psi)),
    body(body = (r, [0.0, 0.0, 0.0])),
    gravity = [0.0, 0.0, -g],
)]
pub struct GeneralTop {
    /// The body in axes whose origin is the fixed point.
    pub body: RigidBody,
    /// The acceleration of gravity in m/s², downwards.
    pub g: f64,
}
