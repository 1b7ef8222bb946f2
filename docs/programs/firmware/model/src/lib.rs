//! A cart with a pole and its law, for firmware and simulation.
#![no_std]

use lagrangian::nalgebra::RowVector4;
use lagrangian::prelude::*;

/// A pole on a cart that a motor pushes; θ is the angle from upright.
#[derive(Lagrangian, Clone, Debug)]
#[lagrangian(
    taylor,
    coordinates(x, theta),
    define(tip = [x + l * sin(theta), l * cos(theta)]),
    kinetic = 0.5 * cart * dot(x).powi(2) + 0.5 * pole * dot(tip).norm_squared(),
    potential = pole * g * tip.y,
    force(x = push),
)]
pub struct CartPole<S: Scalar> {
    /// The mass of the cart in kg.
    pub cart: S,
    /// The mass at the tip of the pole in kg.
    pub pole: S,
    /// The length of the pole in m.
    pub l: S,
    /// The acceleration of gravity in m/s².
    pub g: S,
    /// The force of the motor in N.
    #[lagrangian(input)]
    pub push: S,
}

impl<S: Scalar> CartPole<S> {
    /// The cart and pole of the laboratory.
    pub fn new() -> Self {
        let [cart, pole, l, g, push] = [1.0, 0.2, 0.5, 9.81, 0.0].map(S::from_f64);
        Self {
            cart,
            pole,
            l,
            g,
            push,
        }
    }
}

impl<S: Scalar> Default for CartPole<S> {
    fn default() -> Self {
        Self::new()
    }
}

/// The law u = −K x with the gain K of a regulator, limited to 20 N.
pub fn law<S: Scalar>(gain: &RowVector4<S>, x: &State<S, 2>) -> S {
    let by_position = gain[0] * x.q[0] + gain[1] * x.q[1];
    let push = by_position + gain[2] * x.v[0] + gain[3] * x.v[1];
    let limit = S::from_f64(20.0);
    (-push).max(-limit).min(limit)
}

/// Computed torque: the force that gives the cart a wanted acceleration.
pub fn computed_force<S: Scalar>(model: &CartPole<S>, x: &State<S, 2>, wanted: S) -> S {
    let accelerations = model.with_inputs([S::zero()]).accelerations(x);
    let by_force = model.input_jacobian::<1>(x)[0];
    (wanted - accelerations[0]) / by_force
}
