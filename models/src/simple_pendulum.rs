//! A particle on a circle.

use lagrangian::prelude::*;

/// A particle on a rod without mass that swings in a plane: the angle θ from the downward vertical.
///
/// ```
/// use lagrangian::elliptic::Modulus;
/// use lagrangian::prelude::*;
/// use lagrangian_models::SimplePendulum;
///
/// let pendulum = SimplePendulum { m: 0.3, l: 0.8, g: 9.81 };
/// let amplitude = 2.5_f64;
/// let start = State::new(0.0, amplitude, 0.0);
/// // It is back after 4 √(l/g) K(sin² ½θ₀).
/// let modulus = Modulus::new((0.5 * amplitude).sin().powi(2), (0.5 * amplitude).cos().powi(2));
/// let period = 4.0 * (0.8_f64 / 9.81).sqrt() * modulus.complete_first();
/// let end = Problem::new(&pendulum, start).solve(period, Taylor::new())?;
/// assert!((end.q[0] - amplitude).abs() < 1e-13 && end.v[0].abs() < 1e-12);
/// # Ok::<(), IntegrationError>(())
/// ```
#[derive(Lagrangian, Clone, Debug)]
#[lagrangian(
    taylor,
    reflect,
    coordinates(theta),
    kinetic = 0.5 * m * (l * dot(theta)).powi(2),
    potential = -m * g * l * cos(theta),
)]
pub struct SimplePendulum {
    /// The mass in kg.
    pub m: f64,
    /// The length of the rod in m.
    pub l: f64,
    /// The acceleration of gravity in m/s².
    pub g: f64,
}
