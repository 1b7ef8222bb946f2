//! A pole on a cart.

use lagrangian::prelude::*;

/// A cart on a straight track, which a force pushes, and a pole that turns freely on it: the position x of the cart, and the angle
/// θ of the pole from the upward vertical, towards +x.
///
/// The pole is a body in axes whose origin is its joint; it points along its z axis, and turns about y.
///
/// ```
/// use lagrangian::prelude::*;
/// use lagrangian_models::CartPole;
///
/// // A point mass on a rod: A. G. Barto, R. S. Sutton & C. W. Anderson (1983), without friction.
/// let (m, l, mass, g) = (0.1, 0.5, 1.0, 9.81);
/// let pole = RigidBody::particle(m, Vector3::new(0.0, 0.0, l))?;
/// let model = CartPole { cart: mass, pole, g, push: 2.0 };
/// let (theta, rate) = (0.4_f64, 1.3);
/// let found = model.accelerations(&State::new(0.0, [0.0, theta], [0.5, rate]));
/// let (sin, cos) = theta.sin_cos();
/// let along = (2.0 + m * l * rate * rate * sin) / (mass + m);
/// let expected = (g * sin - cos * along) / (l * (1.0 - m * cos * cos / (mass + m)));
/// assert!((found[CartPole::THETA] - expected).abs() < 1e-13);
/// # Ok::<(), lagrangian::rigid_body::BodyError>(())
/// ```
#[derive(Lagrangian, Clone, Debug)]
#[lagrangian(
    taylor,
    reflect,
    coordinates(x, theta),
    kinetic = 0.5 * cart * dot(x).powi(2),
    body(pole = (rotation_y(theta), [x, 0.0, 0.0])),
    gravity = [0.0, 0.0, -g],
    force(x = push),
)]
pub struct CartPole {
    /// The mass of the cart in kg.
    pub cart: f64,
    /// The pole in axes whose origin is its joint.
    pub pole: RigidBody,
    /// The acceleration of gravity in m/s².
    pub g: f64,
    /// The force on the cart in N, which a controller sets.
    #[lagrangian(input)]
    pub push: f64,
}
