//! A symmetric top under its weight.

use lagrangian::prelude::*;

/// A heavy symmetric top with a fixed point on its axis, in precession φ, nutation θ and spin ψ: T is (4.7) and V = m g l cos θ,
/// with the moments of inertia about the fixed point, I + m l² and `I_s`. The momenta of φ and ψ are constant (4.8).
///
/// The height l of the body is the distance of its centre of gravity from the fixed point: the top stands for l > 0, and hangs for
/// l < 0 or θ > π/2. The angles are singular where sin θ = 0.
///
/// ```
/// use lagrangian::prelude::*;
/// use lagrangian::rigid_body::SteadyPrecession;
/// use lagrangian_models::SymmetricTop;
///
/// let top = SymmetricTop { body: SymmetricBody::new(0.5, 0.04, 4e-4, 3e-4)?, g: 9.81 };
/// let (theta, spin) = (0.6_f64, 200.0);
/// let across = top.body.transverse_moment_about_origin();
/// let slope = -0.5 * 9.81 * 0.04 * theta.sin();
/// let precession = SteadyPrecession::of_top(across, 3e-4, spin, theta, slope);
/// let SteadyPrecession::Two { slow, fast } = precession else { unreachable!() };
/// for rate in [slow, fast] {
///     // The axial velocity ω₃ = ψ̇ + φ̇ cos θ is given (4.11): θ stays.
///     let steady = State::new(0.0, [0.0, theta, 0.0], [rate, 0.0, spin - rate * theta.cos()]);
///     assert!(top.accelerations(&steady).norm() < 1e-9);
/// }
/// # Ok::<(), lagrangian::rigid_body::BodyError>(())
/// ```
#[derive(Lagrangian, Clone, Debug)]
#[lagrangian(
    taylor,
    reflect,
    coordinates(phi, theta, psi),
    define(r = rotation_zxz(phi, theta, psi)),
    body(body = (r, [0.0, 0.0, 0.0])),
    gravity = [0.0, 0.0, -g],
)]
pub struct SymmetricTop {
    /// The body, whose axis goes through the fixed point, the origin of its axes.
    pub body: SymmetricBody,
    /// The acceleration of gravity in m/s², downwards.
    pub g: f64,
}
