//! A particle on a sphere.

use lagrangian::prelude::*;

/// A particle on a rod without mass that swings about a fixed point: the angle θ from the downward vertical, and the azimuth φ, of
/// which the momentum is constant. The angles are singular where sin θ = 0.
///
/// ```
/// use lagrangian::prelude::*;
/// use lagrangian_models::SphericalPendulum;
///
/// let pendulum = SphericalPendulum { m: 0.3, l: 0.8, g: 9.81 };
/// // It goes round a horizontal circle at φ̇² = g/(l cos θ).
/// let theta = 0.7_f64;
/// let rate = (9.81 / (0.8 * theta.cos())).sqrt();
/// let conical = State::new(0.0, [theta, 0.0], [0.0, rate]);
/// assert!(pendulum.accelerations(&conical).norm() < 1e-14);
/// ```
#[derive(Lagrangian, Clone, Debug)]
#[lagrangian(
    taylor,
    reflect,
    coordinates(theta, phi),
    define(p = l * [sin(theta) * cos(phi), sin(theta) * sin(phi), -cos(theta)]),
    kinetic = 0.5 * m * dot(p).norm_squared(),
    potential = m * g * p.z,
    output(position = p),
)]
pub struct SphericalPendulum {
    /// The mass in kg.
    pub m: f64,
    /// The length of the rod in m.
    pub l: f64,
    /// The acceleration of gravity in m/s².
    pub g: f64,
}
