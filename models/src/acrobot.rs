//! Two links with a motor between them.

use lagrangian::prelude::*;

/// The acrobot: two links that swing in a vertical plane, like a gymnast on a bar, with a motor at the joint between them
/// (M. W. Spong, The swing up control problem for the acrobot, 1995). Both links hang at θ₁ = θ₂ = 0; θ₂ is the angle of
/// the second link relative to the first.
///
/// ```
/// use lagrangian::nalgebra::{Matrix2, Vector2};
/// use lagrangian::prelude::*;
/// use lagrangian_models::Acrobot;
///
/// let (m1, m2, l1, c1, c2, i1, i2, g) = (1.0, 0.8, 0.5, 0.3, 0.4, 0.02, 0.03, 9.81);
/// let model = Acrobot { m1, m2, l1, c1, c2, i1, i2, g, torque: 0.7 };
/// let state = State::new(0.0, [0.4, 0.9], [1.1, -0.7]);
/// let ([a, b], [u, v]) = ([0.4_f64, 0.9_f64], [1.1, -0.7]);
/// let coupling = m2 * (c2 * c2 + l1 * c2 * b.cos()) + i2;
/// let second = m2 * c2 * c2 + i2;
/// let first = m1 * c1 * c1 + i1 + m2 * (l1 * l1 + l1 * c2 * b.cos()) + coupling;
/// let mass = Matrix2::new(first, coupling, coupling, second);
/// let weight = m2 * c2 * g * (a + b).sin();
/// let forcing = Vector2::new(
///     m2 * l1 * c2 * b.sin() * (v * v + 2.0 * u * v) - (m1 * c1 + m2 * l1) * g * a.sin() - weight,
///     0.7 - m2 * l1 * c2 * b.sin() * u * u - weight,
/// );
/// assert!((mass * model.accelerations(&state) - forcing).norm() < 1e-14);
/// ```
#[derive(Lagrangian, Clone, Debug)]
#[lagrangian(
    taylor,
    reflect,
    coordinates(theta1, theta2),
    define(
        elbow = l1 * [sin(theta1), -cos(theta1)],
        p1 = c1 * [sin(theta1), -cos(theta1)],
        p2 = elbow + c2 * [sin(theta1 + theta2), -cos(theta1 + theta2)],
    ),
    kinetic = 0.5 * m1 * dot(p1).norm_squared() + 0.5 * i1 * dot(theta1).powi(2)
        + 0.5 * m2 * dot(p2).norm_squared() + 0.5 * i2 * (dot(theta1) + dot(theta2)).powi(2),
    potential = g * (m1 * p1.y + m2 * p2.y),
    force(theta2 = torque),
    output(elbow = elbow),
)]
pub struct Acrobot {
    /// The mass of the first link in kg.
    pub m1: f64,
    /// The mass of the second link in kg.
    pub m2: f64,
    /// The length of the first link in m, from the bar to the motor.
    pub l1: f64,
    /// The distance of the first centre of gravity from the bar in m.
    pub c1: f64,
    /// The distance of the second centre of gravity from the motor in m.
    pub c2: f64,
    /// The moment of inertia of the first link about its centre of gravity in kg m².
    pub i1: f64,
    /// The moment of inertia of the second link about its centre of gravity in kg m².
    pub i2: f64,
    /// The acceleration of gravity in m/s².
    pub g: f64,
    /// The torque of the motor in N m, which a controller sets.
    #[lagrangian(input)]
    pub torque: f64,
}
