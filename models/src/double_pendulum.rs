//! Two particles, one below the other.

use lagrangian::prelude::*;

/// Two particles on rods without mass that swing in a plane, the second on the first: the angles of both rods from the
/// downward vertical.
///
/// ```
/// use lagrangian::nalgebra::Matrix2;
/// use lagrangian::prelude::*;
/// use lagrangian_models::DoublePendulum;
///
/// let pendulum = DoublePendulum { m1: 0.3, m2: 0.3, l1: 0.5, l2: 0.5, g: 9.81 };
/// // Equal particles and rods: ω² = (2 ∓ √2) g/l about the downward equilibrium.
/// let rest = State::new(0.0, [0.0; 2], [0.0; 2]);
/// let stiffness: Matrix2<f64> = -pendulum.linearize(&rest).position;
/// let squares = [2.0 - 2.0_f64.sqrt(), 2.0 + 2.0_f64.sqrt()].map(|x| x * 9.81 / 0.5);
/// assert!((stiffness.trace() - squares[0] - squares[1]).abs() < 1e-12);
/// assert!((stiffness.determinant() - squares[0] * squares[1]).abs() < 1e-10);
/// ```
#[derive(Lagrangian, Clone, Debug)]
#[lagrangian(
    taylor,
    reflect,
    coordinates(theta[2]),
    define(
        p1 = l1 * [sin(theta[0]), -cos(theta[0])],
        p2 = p1 + l2 * [sin(theta[1]), -cos(theta[1])],
    ),
    kinetic = 0.5 * m1 * dot(p1).norm_squared() + 0.5 * m2 * dot(p2).norm_squared(),
    potential = g * (m1 * p1.y + m2 * p2.y),
    output(first = p1, second = p2),
)]
pub struct DoublePendulum {
    /// The mass of the first particle in kg.
    pub m1: f64,
    /// The mass of the second particle in kg.
    pub m2: f64,
    /// The length of the first rod in m.
    pub l1: f64,
    /// The length of the second rod in m.
    pub l2: f64,
    /// The acceleration of gravity in m/s².
    pub g: f64,
}
