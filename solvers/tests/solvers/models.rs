//! The models of these tests.

use lagrangian::nalgebra::SVector;
use lagrangian::prelude::*;
use lagrangian::{At, Dynamics, Phase, Scalar};

/// A heavy top, pinned at a fixed point; z-x-z Euler angles.
#[derive(Lagrangian)]
#[lagrangian(
    taylor,
    coordinates(phi, theta, psi),
    define(
        w1 = dot(phi) * sin(theta) * sin(psi) + dot(theta) * cos(psi),
        w2 = dot(phi) * sin(theta) * cos(psi) - dot(theta) * sin(psi),
        w3 = dot(phi) * cos(theta) + dot(psi),
    ),
    kinetic = 0.5 * (i1 * w1.powi(2) + i2 * w2.powi(2) + i3 * w3.powi(2)),
    potential = weight * l * cos(theta),
)]
pub(crate) struct HeavyTop {
    i1: f64,
    i2: f64,
    i3: f64,
    weight: f64,
    l: f64,
}

/// A top without symmetry, tilted and spinning.
pub(crate) fn top() -> (HeavyTop, State<f64, 3>) {
    let top = HeavyTop {
        i1: 1.2,
        i2: 1.0,
        i3: 0.5,
        weight: 12.0,
        l: 0.4,
    };
    (top, State::new(0.0, [0.1, 0.5, 0.2], [0.3, 0.1, 12.0]))
}

/// Van der Pol's oscillator, ẍ = μ (1 − x²) ẋ − x: a force of friction that is negative near x = 0. It is stiff for large μ.
#[derive(Lagrangian)]
#[lagrangian(
    taylor,
    coordinates(x),
    kinetic = 0.5 * dot(x).powi(2),
    potential = 0.5 * x.powi(2),
    force(x = mu * (1.0 - x.powi(2)) * dot(x)),
)]
pub(crate) struct VanDerPol {
    mu: f64,
}

/// Two relaxations, of which the second begins at t = 0.81 μ, with the fast passages between them.
pub(crate) fn van_der_pol() -> (VanDerPol, State<f64, 1>, f64) {
    (
        VanDerPol { mu: 200.0 },
        State::new(0.0, [2.0], [0.0]),
        400.0,
    )
}

/// ẍ = 6 x², for which x = 1/(1 − t)² is infinite at t = 1.
#[derive(Lagrangian)]
#[lagrangian(coordinates(x), kinetic = 0.5 * dot(x).powi(2), potential = -strength * x.powi(3))]
pub(crate) struct Runaway {
    strength: f64,
}

pub(crate) fn runaway() -> (Runaway, State<f64, 1>) {
    (Runaway { strength: 2.0 }, State::new(0.0, [1.0], [2.0]))
}

/// A pendulum on a cart that is pushed, with a support that shakes: its equations contain the time.
#[derive(Lagrangian)]
#[lagrangian(
    taylor,
    coordinates(x, theta),
    define(px = x + l * sin(theta), py = l * cos(theta) + shake * cos(omega * t)),
    kinetic = 0.5 * m_cart * dot(x).powi(2) + 0.5 * m * (dot(px).powi(2) + dot(py).powi(2)),
    potential = m * g * py,
    force(x = push),
)]
pub(crate) struct CartPole {
    m_cart: f64,
    m: f64,
    l: f64,
    g: f64,
    shake: f64,
    omega: f64,
    #[lagrangian(input)]
    push: f64,
}

/// The pole falls over without a law.
pub(crate) fn cart_pole() -> (CartPole, State<f64, 2>) {
    let cart = CartPole {
        m_cart: 1.0,
        m: 0.2,
        l: 0.7,
        g: 9.81,
        shake: 0.01,
        omega: 7.0,
        push: 0.0,
    };
    (cart, State::new(0.5, [0.1, 0.2], [-0.1, 0.0]))
}

/// A law that holds the pole upright, on any scalar; it saturates softly, and is stiff by its gain on the velocity of the cart.
pub(crate) fn balance<S: Scalar>(state: &State<S, 2>) -> S {
    let State { t, x } = state;
    let term = |gain: f64, of: S| S::from_f64(gain) * of;
    let error = term(2.0, x.q[0]) + term(6.0, x.v[0]) + term(40.0, x.q[1]) + term(10.0, x.v[1]);
    term(30.0, error.tanh()) + term(0.1, t.sin())
}

/// The cart under that law, on any scalar, in terms of the traits alone.
pub(crate) struct Balanced<'a>(pub(crate) &'a CartPole);

impl<S: Scalar> Dynamics<S> for Balanced<'_> {
    type State = Phase<S, 2>;

    fn derivative(&self, t: S, x: &Phase<S, 2>) -> Phase<S, 2> {
        let state = At { t, x: *x };
        let pushed = self.0.with_inputs(balance(&state));
        let v = pushed.accelerations(&state);
        Phase::new(x.v, v)
    }
}

/// A spring and its damper, by the components of a plain vector.
pub(crate) struct Spring {
    pub(crate) rate: f64,
    pub(crate) damping: f64,
}

impl<S: Scalar> Dynamics<S> for Spring {
    type State = SVector<S, 2>;

    fn derivative(&self, _: S, x: &SVector<S, 2>) -> SVector<S, 2> {
        let [rate, damping] = [self.rate, self.damping].map(S::from_f64);
        SVector::from([x[1], -rate * x[0] - damping * x[1]])
    }
}
