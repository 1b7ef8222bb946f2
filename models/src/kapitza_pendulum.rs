//! A pendulum that stands on a shaking pivot.

use lagrangian::prelude::*;

/// Kapitza's pendulum: a particle on a rod without mass whose pivot moves up and down, a cos ωt. θ is the angle from the
/// upright, about which it swings if a² ω² > 2 g l (P. L. Kapitza, 1951; Landau and Lifshitz, Mechanics, §30).
///
/// ```
/// use lagrangian::prelude::*;
/// use lagrangian_models::KapitzaPendulum;
///
/// let shaken = KapitzaPendulum { m: 0.1, l: 0.2, g: 9.81, a: 0.01, omega: 400.0 };
/// let start = State::new(0.0, [0.1], [0.0]);
/// // ω² a² = 16 m²/s², and 2 g l = 3.9 m²/s².
/// let end = Problem::new(&shaken, start).solve(2.0, Taylor::new())?;
/// assert!(end.q[0].abs() < 0.12);
/// let slow = KapitzaPendulum { omega: 100.0, ..shaken };
/// let end = Problem::new(&slow, start).solve(0.5, Taylor::new())?;
/// assert!(end.q[0].abs() > 1.0);
/// # Ok::<(), IntegrationError>(())
/// ```
#[derive(Lagrangian, Clone, Debug)]
#[lagrangian(
    taylor,
    reflect,
    energy_balance,
    coordinates(theta),
    define(position = [l * sin(theta), l * cos(theta) + a * cos(omega * t)]),
    kinetic = 0.5 * m * dot(position).norm_squared(),
    potential = m * g * position.y,
    output(position = position),
)]
pub struct KapitzaPendulum {
    /// The mass in kg.
    pub m: f64,
    /// The length of the rod in m.
    pub l: f64,
    /// The acceleration of gravity in m/s².
    pub g: f64,
    /// The amplitude of the pivot in m.
    pub a: f64,
    /// The angular frequency of the pivot in rad/s.
    pub omega: f64,
}
