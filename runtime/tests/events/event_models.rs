//! What the tests of events and of reactions share: the methods, a pendulum and a ball.

use core::f64::consts::PI;

use lagrangian::prelude::*;

/// Runs a test under each method, with the error that it makes in these tests.
#[allow(unused_macros)]
macro_rules! under_each_method {
    (|$method:ident, $error:ident| $test:block) => {{
        {
            let ($method, $error) = (RungeKutta::classical(1.0 / 256.0), 1e-8);
            $test
        }
        {
            let method = Dop853::new().relative_tolerance(1e-13);
            let ($method, $error) = (method.absolute_tolerance(1e-13), 1e-11);
            $test
        }
        {
            let ($method, $error) = (Taylor::new(), 1e-13);
            $test
        }
        {
            let ($method, $error) = (Taylor::order_12().relative_tolerance(1e-10), 1e-8);
            $test
        }
    }};
}

#[allow(unused_imports)]
pub(crate) use under_each_method;

/// A pendulum of unit length; small ones are balls of a cradle.
#[derive(Lagrangian, Clone, Debug)]
#[lagrangian(
    taylor,
    coordinates(theta),
    kinetic = 0.5 * m * (l * dot(theta)).powi(2),
    potential = -m * g * l * cos(theta),
)]
pub(crate) struct Pendulum {
    pub(crate) m: f64,
    pub(crate) g: f64,
    pub(crate) l: f64,
}

pub(crate) const PENDULUM: Pendulum = Pendulum {
    m: 0.3,
    g: 9.81,
    l: 0.7,
};

/// A ball above the ground.
#[derive(Lagrangian, Clone, Debug)]
#[lagrangian(
    taylor,
    coordinates(height),
    kinetic = 0.5 * m * dot(height).powi(2),
    potential = m * g * height,
)]
pub(crate) struct Ball {
    pub(crate) m: f64,
    pub(crate) g: f64,
}

pub(crate) const BALL: Ball = Ball { m: 0.2, g: 9.81 };

/// 4 K(k) √(l/g) with k = sin ½θ₀, by the arithmetic-geometric mean.
pub(crate) fn period(pendulum: &Pendulum, amplitude: f64) -> f64 {
    let (mut a, mut b) = (1.0, (0.5 * amplitude).cos());
    for _ in 0..8 {
        (a, b) = (0.5 * (a + b), f64::sqrt(a * b));
    }
    2.0 * PI / a * (pendulum.l / pendulum.g).sqrt()
}

pub(crate) fn times<X>(events: &[Occurrence<X>], event: usize) -> Vec<f64> {
    let events = events.iter().filter(|occurrence| occurrence.event == event);
    events.map(|occurrence| occurrence.t).collect()
}
