//! The cart and its pole, and how it moves under a gain.

use lagrangian::nalgebra::RowVector4;
use lagrangian::prelude::*;

/// A cart on a rail, and on it a point mass at the end of a massless pole.
#[derive(Lagrangian)]
#[lagrangian(
    // The position of the cart, and the angle of the pole from upright.
    coordinates(x, theta),
    define(px = x + l * sin(theta), py = l * cos(theta)),
    kinetic = 0.5 * cart * dot(x).powi(2) + 0.5 * pole * (dot(px).powi(2) + dot(py).powi(2)),
    potential = pole * g * py,
    force(x = push),
)]
pub(crate) struct CartPole {
    /// Mass of the cart in kg.
    pub(crate) cart: f64,
    /// Mass at the end of the pole in kg.
    pub(crate) pole: f64,
    /// Length of the pole in m.
    pub(crate) l: f64,
    /// Acceleration of gravity in m/s².
    pub(crate) g: f64,
    /// Force on the cart in N, which the controller sets.
    #[lagrangian(input)]
    pub(crate) push: f64,
}

/// How long motions are followed, in s.
pub(crate) const DURATION: f64 = 8.0;

/// The time between two points of a motion, in s.
const INTERVAL: f64 = 0.02;

/// A point of a motion: the state, and the force on the cart.
pub(crate) type Point = (State<f64, 2>, f64);

/// The force u = −K x, where the equilibrium is at the origin.
fn force(gain: &RowVector4<f64>, state: &State<f64, 2>) -> f64 {
    -(gain[0] * state.q[0] + gain[1] * state.q[1] + gain[2] * state.v[0] + gain[3] * state.v[1])
}

impl CartPole {
    /// The motion from rest at an angle in rad, in continuous time, until the pole is level if it falls.
    pub(crate) fn continuous(
        &self,
        gain: &RowVector4<f64>,
        tilt: f64,
    ) -> Result<Vec<Point>, IntegrationError> {
        let law = |state: &State<f64, 2>| force(gain, state);
        let mut state = State::new(0.0, [0.0, tilt], [0.0, 0.0]);
        let mut points = vec![(state, law(&state))];
        while state.t < DURATION && is_up(&state) {
            let problem = Problem::new(self, state).feedback(law);
            state = problem.solve(state.t + INTERVAL, Dop853::new())?.last;
            points.push((state, law(&state)));
        }
        Ok(points)
    }

    /// The motion with a force that is set every `period` seconds and held in between.
    pub(crate) fn sampled(
        &self,
        gain: &RowVector4<f64>,
        tilt: f64,
        period: f64,
    ) -> Result<Vec<Point>, IntegrationError> {
        let mut state = State::new(0.0, [0.0, tilt], [0.0, 0.0]);
        let mut points = Vec::new();
        while state.t < DURATION && is_up(&state) {
            let held = force(gain, &state);
            points.push((state, held));
            let pushed = self.with_inputs([held]);
            let problem = Problem::new(&pushed, state);
            state = problem.solve(state.t + period, Dop853::new())?.last;
            points.push((state, held));
        }
        Ok(points)
    }
}

/// Whether the pole is above the horizontal.
fn is_up(state: &State<f64, 2>) -> bool {
    state.q[1].abs() < std::f64::consts::FRAC_PI_2
}

/// Whether a motion ends near the equilibrium.
pub(crate) fn is_balanced(motion: &[Point]) -> bool {
    let is_still = |(state, _): &Point| state.q.norm() < 0.05 && state.v.norm() < 0.05;
    motion.last().is_some_and(is_still)
}

/// The largest tilt in rad from which motions are balanced, by bisection.
pub(crate) fn largest_tilt(
    motion: impl Fn(f64) -> Result<Vec<Point>, IntegrationError>,
) -> Result<f64, IntegrationError> {
    let (mut balanced, mut lost) = (0.0, std::f64::consts::FRAC_PI_2);
    for _ in 0..16 {
        let tilt = 0.5 * (balanced + lost);
        if is_balanced(&motion(tilt)?) {
            balanced = tilt;
        } else {
            lost = tilt;
        }
    }
    Ok(balanced)
}
