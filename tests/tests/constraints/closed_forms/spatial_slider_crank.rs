//! A slider-crank mechanism in space, whose rod is a body with two angles and ends in a ball joint: against the kinematics of the
//! loop, and the time as a quadrature.

use lagrangian::prelude::*;
use lagrangian_tests::Figures;

use super::one_freedom::Freedom;
use super::{TOLERANCE, by_both_methods, compare};

/// A crank that turns about an axis at a height above the line of the slider and along it, a rod, and the slider at x.
#[derive(Clone, Lagrangian)]
#[lagrangian(
    taylor,
    coordinates(theta, alpha, beta, x),
    define(
        pin = [0.0, r * cos(theta), height + r * sin(theta)],
        turned = rotation_z(alpha) * rotation_y(beta),
        center = pin + turned * [0.5 * l, 0.0, 0.0],
        end = pin + turned * [l, 0.0, 0.0],
    ),
    kinetic = 0.5 * (i * dot(theta).powi(2) + slider * dot(x).powi(2)),
    body(rod = (turned, center)),
    gravity = [0.0, 0.0, -g],
    constraint(joint = end - [x, 0.0, 0.0]),
    output(force = reaction(joint)),
)]
struct SpatialSliderCrank {
    rod: PrincipalBody,
    r: f64,
    l: f64,
    height: f64,
    i: f64,
    slider: f64,
    g: f64,
}

impl SpatialSliderCrank {
    fn new() -> Self {
        let (mass, l) = (0.7, 1.2);
        let moment = mass * l * l / 12.0;
        Self {
            // A thin rod.
            rod: PrincipalBody::new(mass, [0.0, moment, moment]).expect("a body"),
            r: 0.25,
            l,
            height: 0.4,
            i: 0.05,
            slider: 0.9,
            g: 9.81,
        }
    }

    /// The place of the slider at an angle, with its first and second derivative.
    fn slider_at(&self, theta: f64) -> [f64; 3] {
        let (sine, cosine) = theta.sin_cos();
        let offset = self.height * self.r;
        let square = self.r * self.r + self.height * self.height + 2.0 * offset * sine;
        let x = (self.l * self.l - square).sqrt();
        let slope = -offset * cosine / x;
        [x, slope, (offset * sine - slope * slope) / x]
    }

    /// The angles of the rod, and their derivatives by the angle of the crank.
    fn rod_at(&self, theta: f64) -> ([f64; 2], [f64; 2]) {
        let (sine, cosine) = theta.sin_cos();
        let (across, up) = (self.r * cosine, self.height + self.r * sine);
        let [x, slope, _] = self.slider_at(theta);
        let length = x.hypot(across);
        let alpha = (-across).atan2(x);
        let beta = up.atan2(length);
        let turning = (x * self.r * sine + across * slope) / (length * length);
        let raising = self.r * cosine / length;
        ([alpha, beta], [turning, raising])
    }

    /// I in T = ½ I θ̇²: a thin rod between points with the velocities a and b has ⅙ m (a² + a·b + b²).
    fn moment(&self, theta: f64) -> f64 {
        let [_, slope, _] = self.slider_at(theta);
        let squares = self.r * self.r + slope * slope;
        self.i + self.rod.mass() / 3.0 * squares + self.slider * slope * slope
    }

    fn potential(&self, theta: f64) -> f64 {
        0.5 * self.rod.mass() * self.g * (self.height + self.r * theta.sin())
    }
}

#[test]
fn the_crank_in_space_turns_as_its_energy_says() {
    let mechanism = SpatialSliderCrank::new();
    let (theta, speed) = (0.3, -9.0);
    let ([alpha, beta], rates) = mechanism.rod_at(theta);
    let [x, slope, _] = mechanism.slider_at(theta);
    let v = [1.0, rates[0], rates[1], slope].map(|rate| rate * speed);
    let start = State::new(0.0, [theta, alpha, beta, x], v);
    let (moment, potential) = (|q| mechanism.moment(q), |q| mechanism.potential(q));
    let freedom = Freedom::starting(moment, potential, theta, speed);
    let mut figures = Figures::new();
    for (tolerance, states) in by_both_methods(&mechanism, start, (5.0, 100)) {
        for state in &states {
            let at = (state.t, tolerance);
            let [angle, q @ ..]: [f64; 4] = state.q.into();
            let ([alpha, beta], [turning, raising]) = mechanism.rod_at(angle);
            let [x, slope, curvature] = mechanism.slider_at(angle);
            compare(&mut figures, "loop", at, &q, &[alpha, beta, x]);
            let rate = freedom.rate(angle);
            let expected = [1.0, turning, raising, slope].map(|slope| slope * rate);
            compare(&mut figures, "rates", at, state.v.as_slice(), &expected);
            let elapsed = freedom.time(angle);
            compare(&mut figures, "time", at, &[elapsed], &[state.t]);
            // The rod pulls the slider.
            let w = state.v[0];
            let accelerations = mechanism.accelerations(state);
            let sliding = slope * accelerations[0] + curvature * w * w;
            compare(&mut figures, "slider", at, &[accelerations[3]], &[sliding]);
            let found = mechanism.outputs(state).force.x;
            let expected = -mechanism.slider * sliding;
            compare(&mut figures, "force", at, &[found], &[expected]);
        }
    }
    figures.finish();
}

/// M q̈ − f − Gᵀ λ and G q̈ + γ vanish, at all angles.
#[test]
fn the_equations_in_space_are_satisfied() {
    let mechanism = SpatialSliderCrank::new();
    let mut figures = Figures::new();
    for i in 0..100 {
        let (theta, speed) = (0.1 * f64::from(i), -9.0);
        let ([alpha, beta], rates) = mechanism.rod_at(theta);
        let [x, slope, curvature] = mechanism.slider_at(theta);
        let v = [1.0, rates[0], rates[1], slope].map(|rate| rate * speed);
        let state = State::new(0.0, [theta, alpha, beta, x], v);
        let accelerations = mechanism.accelerations(&state);
        let reactions = mechanism
            .constraint_jacobian(&state)
            .tr_mul(&mechanism.multipliers(&state));
        let found = mechanism.inverse_dynamics(&state, &accelerations);
        let at = (theta, TOLERANCE);
        compare(
            &mut figures,
            "equations",
            at,
            found.as_slice(),
            reactions.as_slice(),
        );
        let sliding = slope * accelerations[0] + curvature * speed * speed;
        compare(&mut figures, "slider", at, &[accelerations[3]], &[sliding]);
    }
    figures.finish();
}
