//! A body that nothing holds.

use lagrangian::prelude::*;

/// A free body along its principal axes through its centre of gravity: T = ½ m |ẋ|² + ½ (I₁ ω₁² + I₂ ω₂² + I₃ ω₃²), (4.3), in
/// precession φ, nutation θ and spin ψ (4.4).
///
/// Its centre of gravity moves as a particle does, and it rotates by Euler's equations without a moment (3.5)–(3.7). The angles
/// are singular where sin θ = 0.
///
/// ```
/// use lagrangian::nalgebra::Vector3;
/// use lagrangian::prelude::*;
/// use lagrangian::rigid_body::{FreeRotation, RotationState};
/// use lagrangian::rotation::{EulerAngles, EulerSequence};
/// use lagrangian_models::FreeBody;
///
/// let body = PrincipalBody::new(2.0, [1.0, 2.0, 2.8])?;
/// let model = FreeBody { body, gravity: Vector3::new(0.0, 0.0, -9.81) };
/// let start = State::new(0.0, [0.0, 0.0, 0.0, 0.3, 1.2, 0.4], [3.0, 0.0, 4.0, 0.2, 0.9, 1.5]);
/// let end = Problem::new(&model, start).solve(0.8, Taylor::new())?;
///
/// // A parabola, and the closed form of free rotation.
/// assert!((end.q[2] - (4.0 * 0.8 - 0.5 * 9.81 * 0.64)).abs() < 1e-13);
/// let turned = |state: &State<f64, 6>| EulerAngles::new(EulerSequence::Zxz, [state.q[3], state.q[4], state.q[5]]);
/// let omega = turned(&start).angular_velocity(&Vector3::new(0.2, 0.9, 1.5));
/// let closed = FreeRotation::new(&body.inertia(), &RotationState::new(&turned(&start).quaternion(), omega))?;
/// let axis = closed.at(0.8).to_space(&Vector3::z());
/// assert!((turned(&end).rotation() * Vector3::z() - axis).norm() < 1e-12);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Lagrangian, Clone, Debug)]
#[lagrangian(
    taylor,
    reflect,
    coordinates(x: Vector3, phi, theta, psi),
    body(body = (rotation_zxz(phi, theta, psi), x)),
    gravity = gravity,
)]
pub struct FreeBody {
    /// The body.
    pub body: PrincipalBody,
    /// The acceleration of gravity in m/s².
    pub gravity: Vector3<f64>,
}
