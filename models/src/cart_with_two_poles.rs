//! Two poles beside each other on a cart.

use lagrangian::prelude::*;

/// Two poles of different lengths on one cart, upright at θ₁ = θ₂ = 0: a benchmark of control by one force (A. P. Wieland,
/// Evolving neural network controllers for unstable systems, 1991). The poles are uniform rods.
///
/// ```
/// use lagrangian::prelude::*;
/// use lagrangian::analysis::StateSpace;
/// use lagrangian_models::CartWithTwoPoles;
///
/// let model = CartWithTwoPoles {
///     cart: 1.0,
///     m1: 0.1,
///     m2: 0.01,
///     l1: 1.0,
///     l2: 0.1,
///     g: 9.81,
///     push: 0.0,
/// };
/// let state = State::new(0.0, [0.0, 0.3, -0.2], [0.4, 1.0, -2.0]);
/// let [x, first, second] = model.accelerations(&state).into();
/// // Each rod about its joint: ⅔ l θ̈ = g sin θ − ẍ cos θ.
/// for (l, angle, rate) in [(1.0, 0.3_f64, first), (0.1, -0.2, second)] {
///     let torque = 9.81 * angle.sin() - x * angle.cos();
///     assert!((2.0 / 3.0 * l * rate - torque).abs() < 1e-13);
/// }
/// // One force is enough, since the poles differ.
/// let upright = State::new(0.0, [0.0; 3], [0.0; 3]);
/// let plant = StateSpace::<f64, 6, 1, 6>::of(&model, &upright);
/// assert!(plant.controllability().is_complete());
/// ```
#[derive(Lagrangian, Clone, Debug)]
#[lagrangian(
    taylor,
    reflect,
    coordinates(x, theta1, theta2),
    define(
        p1 = [x + 0.5 * l1 * sin(theta1), 0.5 * l1 * cos(theta1)],
        p2 = [x + 0.5 * l2 * sin(theta2), 0.5 * l2 * cos(theta2)],
    ),
    kinetic = 0.5 * cart * dot(x).powi(2)
        + 0.5 * m1 * (dot(p1).norm_squared() + (l1 * dot(theta1)).powi(2) / 12.0)
        + 0.5 * m2 * (dot(p2).norm_squared() + (l2 * dot(theta2)).powi(2) / 12.0),
    potential = g * (m1 * p1.y + m2 * p2.y),
    force(x = push),
)]
pub struct CartWithTwoPoles {
    /// The mass of the cart in kg.
    pub cart: f64,
    /// The mass of the first pole in kg.
    pub m1: f64,
    /// The mass of the second pole in kg.
    pub m2: f64,
    /// The length of the first pole in m.
    pub l1: f64,
    /// The length of the second pole in m.
    pub l2: f64,
    /// The acceleration of gravity in m/s².
    pub g: f64,
    /// The force on the cart in N, which a controller sets.
    #[lagrangian(input)]
    pub push: f64,
}
