//! Mechanical systems for Python. Declare yours beside these, with the clause `reflect`, and add them to the module below.

use lagrangian::prelude::*;

/// A ball that is thrown in a plane above a floor.
#[derive(Lagrangian)]
#[lagrangian(
    taylor,
    reflect,
    coordinates(x, y),
    kinetic = 0.5 * m * (dot(x).powi(2) + dot(y).powi(2)),
    potential = m * g * y,
    event(floor = y),
    output(height = y, position = [x, y]),
)]
pub struct Ball {
    /// The mass in kg.
    m: f64,
    /// The acceleration of gravity in m/s².
    g: f64,
}

/// A pole on a cart that a motor pushes.
#[derive(Lagrangian)]
#[lagrangian(
    taylor,
    reflect,
    coordinates(x, theta),
    define(tip = [x + l * sin(theta), l * cos(theta)]),
    kinetic = 0.5 * cart * dot(x).powi(2) + 0.5 * pole * dot(tip).norm_squared(),
    potential = pole * g * tip.y,
    force(x = push),
    output(tip = tip),
)]
pub struct CartPole {
    /// The mass of the cart in kg.
    cart: f64,
    /// The mass at the tip of the pole in kg.
    pole: f64,
    /// The length of the pole in m.
    l: f64,
    /// The acceleration of gravity in m/s².
    g: f64,
    /// The force of the motor in N.
    #[lagrangian(input)]
    push: f64,
}

/// A heavy top with a fixed point on its axis; z-x-z Euler angles.
#[derive(Lagrangian)]
#[lagrangian(
    taylor,
    reflect,
    coordinates(phi, theta, psi),
    define(r = rotation_zxz(phi, theta, psi)),
    body(body = (r, [0.0, 0.0, 0.0])),
    gravity = [0.0, 0.0, -g],
)]
pub struct Top {
    /// The top, with the fixed point as the origin of its axes.
    body: SymmetricBody,
    /// The acceleration of gravity in m/s².
    g: f64,
}

/// A pendulum in Cartesian coordinates: a mass on a rod whose length is a constraint.
#[derive(Lagrangian)]
#[lagrangian(
    reflect,
    coordinates(x, y),
    kinetic = 0.5 * m * (dot(x).powi(2) + dot(y).powi(2)),
    potential = m * g * y,
    constraint(rod = sqrt(x.powi(2) + y.powi(2)) - l),
)]
pub struct RodPendulum {
    /// The mass in kg.
    m: f64,
    /// The length of the rod in m.
    l: f64,
    /// The acceleration of gravity in m/s².
    g: f64,
}

lagrangian_python::module! {
    /// Mechanical systems whose equations of motion were derived at compile time.
    mechanisms: Ball, CartPole, Top, RodPendulum
}
