//! A pendulum on the turning Earth.

use lagrangian::prelude::*;

/// Foucault's pendulum: a particle on a wire, by its position (x, y) east and north of the lowest point, in axes that turn with
/// the Earth. Gravity contains the centrifugal acceleration at the support; its changes along the pendulum are left out.
///
/// The plane of small oscillations turns by −Ω sin λ, clockwise in the north.
///
/// ```
/// use lagrangian::prelude::*;
/// use lagrangian_models::FoucaultPendulum;
///
/// let paris = FoucaultPendulum {
///     m: 28.0,
///     l: 67.0,
///     g: 9.81,
///     rate: 7.292e-5,
///     latitude: 48.85_f64.to_radians(),
/// };
/// let start = State::new(0.0, [1e-4, 0.0], [0.0, 0.0]);
/// let turn = 7.292e-5 * paris.latitude.sin();
/// let frequency = (9.81_f64 / 67.0 + turn * turn).sqrt();
/// let time = 600.0;
/// let end = Problem::new(&paris, start).solve(time, Taylor::new())?;
/// // In axes that turn with the plane, an ellipse whose smaller axis is turn/frequency of the larger one.
/// let (along, across) = ((frequency * time).cos(), turn / frequency * (frequency * time).sin());
/// let (s, c) = (turn * time).sin_cos();
/// assert!((end.q[0] * 1e4 - (along * c + across * s)).abs() < 1e-7);
/// assert!((end.q[1] * 1e4 - (across * c - along * s)).abs() < 1e-7);
/// # Ok::<(), IntegrationError>(())
/// ```
#[derive(Lagrangian, Clone, Debug)]
#[lagrangian(
    taylor,
    reflect,
    coordinates(x, y),
    define(
        position = [x, y, -sqrt(l.powi(2) - x.powi(2) - y.powi(2))],
        earth = rate * [0.0, cos(latitude), sin(latitude)],
    ),
    kinetic = 0.5 * m * dot(position).norm_squared(),
    // The potential of the Coriolis force is −m v·(Ω × r).
    potential = m * g * position.z - m * dot(position).dot(earth.cross(position)),
    output(height = position.z),
)]
pub struct FoucaultPendulum {
    /// The mass in kg.
    pub m: f64,
    /// The length of the wire in m.
    pub l: f64,
    /// The acceleration of gravity in m/s².
    pub g: f64,
    /// The angular velocity Ω of the Earth in rad/s.
    pub rate: f64,
    /// The latitude λ in rad.
    pub latitude: f64,
}
