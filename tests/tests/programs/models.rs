//! The models of the programs. Their declarations belong to none of them.

use lagrangian::prelude::*;

/// A heavy top, pinned at a fixed point.
#[derive(Lagrangian)]
#[lagrangian(
    taylor,
    coordinates(phi, theta, psi),
    define(w = angular_velocity_zxz(phi, theta, psi)),
    kinetic = 0.5 * w.dot(diagonal([i1, i1, i3]) * w),
    potential = m * g * l * cos(theta),
)]
pub(crate) struct Top {
    pub(crate) i1: f64,
    pub(crate) i3: f64,
    pub(crate) m: f64,
    pub(crate) g: f64,
    pub(crate) l: f64,
}

pub(crate) const TOP: Top = Top {
    i1: 1.2,
    i3: 0.5,
    m: 1.3,
    g: 9.81,
    l: 0.4,
};

/// A ball above a floor.
#[derive(Lagrangian)]
#[lagrangian(
    taylor,
    coordinates(x, height),
    kinetic = 0.5 * m * (dot(x).powi(2) + dot(height).powi(2)),
    potential = m * g * height,
    event(floor = height, apex = dot(height)),
)]
pub(crate) struct Ball {
    pub(crate) m: f64,
    pub(crate) g: f64,
}

pub(crate) const BALL: Ball = Ball { m: 0.1, g: 10.0 };

/// A pendulum with a motor.
#[derive(Lagrangian)]
#[lagrangian(
    taylor,
    coordinates(theta),
    kinetic = 0.5 * m * l.powi(2) * dot(theta).powi(2),
    potential = -m * g * l * cos(theta),
    force(theta = torque),
)]
pub(crate) struct Pendulum {
    pub(crate) m: f64,
    pub(crate) l: f64,
    pub(crate) g: f64,
    #[lagrangian(input)]
    pub(crate) torque: f64,
}

pub(crate) const PENDULUM: Pendulum = Pendulum {
    m: 1.0,
    l: 1.0,
    g: 9.81,
    torque: 0.0,
};

/// A pole on a cart; upright at θ = 0.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(x, theta),
    define(p = [x + l * sin(theta), l * cos(theta)]),
    kinetic = 0.5 * cart * dot(x).powi(2) + 0.5 * pole * dot(p).norm_squared(),
    potential = pole * g * p.y,
    force(x = push),
)]
pub(crate) struct CartPole {
    pub(crate) cart: f64,
    pub(crate) pole: f64,
    pub(crate) l: f64,
    pub(crate) g: f64,
    #[lagrangian(input)]
    pub(crate) push: f64,
}

pub(crate) const CART_POLE: CartPole = CartPole {
    cart: 1.0,
    pole: 0.2,
    l: 0.5,
    g: 9.81,
    push: 0.0,
};

/// A pendulum on any scalar, with an event where it hangs.
#[derive(Lagrangian)]
#[lagrangian(
    taylor,
    coordinates(theta),
    kinetic = 0.5 * l.powi(2) * dot(theta).powi(2),
    potential = -g * l * cos(theta),
    event(bottom = theta),
)]
pub(crate) struct Swing<T: Scalar> {
    pub(crate) l: T,
    pub(crate) g: f64,
}
