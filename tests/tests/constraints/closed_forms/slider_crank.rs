//! A slider-crank mechanism whose loop is a constraint: against the kinematics of the loop, the time as a quadrature, and the forces
//! in its joint by Newton's equations.

use lagrangian::prelude::*;
use lagrangian_tests::Figures;

use super::one_freedom::Freedom;
use super::{by_both_methods, compare};

/// A crank of radius r, a uniform rod of length l that is inclined by phi, and a slider at x on a spring.
#[derive(Clone, Lagrangian)]
#[lagrangian(
    taylor,
    coordinates(theta, phi, x),
    define(
        pin = r * [cos(theta), sin(theta)],
        rod = l * [cos(phi), -sin(phi)],
        center = pin + 0.5 * rod,
    ),
    kinetic = 0.5 * (i * dot(theta).powi(2) + m * dot(center).norm_squared() + m * l.powi(2) / 12.0 * dot(phi).powi(2)),
    kinetic = 0.5 * slider * dot(x).powi(2),
    potential = m * g * center.y + 0.5 * k * x.powi(2),
    constraint(joint = pin + rod - [x, 0.0]),
    output(force = reaction(joint), guide = -reaction(joint[1])),
)]
struct SliderCrank {
    r: f64,
    l: f64,
    i: f64,
    m: f64,
    slider: f64,
    g: f64,
    k: f64,
}

const MECHANISM: SliderCrank = SliderCrank {
    r: 0.3,
    l: 1.0,
    i: 0.04,
    m: 0.8,
    slider: 1.5,
    g: 9.81,
    k: 20.0,
};

/// The angle of the rod and the place of the slider at an angle of the crank, with their first and second derivatives by it.
fn loop_at(theta: f64) -> [[f64; 3]; 2] {
    let SliderCrank { r, l, .. } = MECHANISM;
    let (sine, cosine) = theta.sin_cos();
    let phi = (r * sine / l).asin();
    let (s, c) = phi.sin_cos();
    let first = r * cosine / (l * c);
    let second = (-r * sine / l + s * first * first) / c;
    let x = r * cosine + l * c;
    let slope = -r * sine - l * s * first;
    let curvature = -r * cosine - l * (c * first * first + s * second);
    [[phi, first, second], [x, slope, curvature]]
}

/// The moment of inertia I(θ) in T = ½ I θ̇².
fn moment(theta: f64) -> f64 {
    let SliderCrank {
        r, l, i, m, slider, ..
    } = MECHANISM;
    let [[phi, first, _], [_, slope, _]] = loop_at(theta);
    let (s, c) = phi.sin_cos();
    let center = [
        -r * theta.sin() - 0.5 * l * s * first,
        r * theta.cos() - 0.5 * l * c * first,
    ];
    let translation = center[0] * center[0] + center[1] * center[1];
    i + m * (translation + l * l / 12.0 * first * first) + slider * slope * slope
}

fn potential(theta: f64) -> f64 {
    let SliderCrank { r, m, g, k, .. } = MECHANISM;
    let x = loop_at(theta)[1][0];
    0.5 * m * g * r * theta.sin() + 0.5 * k * x * x
}

#[test]
fn the_crank_turns_as_its_energy_says() {
    let SliderCrank {
        m, l, slider, g, k, ..
    } = MECHANISM;
    let (theta, speed) = (0.4, 12.0);
    let [[phi, first, _], [x, slope, _]] = loop_at(theta);
    let start = State::new(0.0, [theta, phi, x], [speed, first * speed, slope * speed]);
    let freedom = Freedom::starting(moment, potential, theta, speed);
    let mut figures = Figures::new();
    for (tolerance, states) in by_both_methods(&MECHANISM, start, (5.0, 100)) {
        for state in &states {
            let at = (state.t, tolerance);
            let [angle, q @ ..]: [f64; 3] = state.q.into();
            let [phi, x] = loop_at(angle);
            let w = state.v[0];
            compare(&mut figures, "loop", at, &q, &[phi[0], x[0]]);
            let found = [w, state.v[1], state.v[2]];
            let expected = freedom.rate(angle);
            let expected = [expected, phi[1] * expected, x[1] * expected];
            compare(&mut figures, "rates", at, &found, &expected);
            let elapsed = freedom.time(angle);
            compare(&mut figures, "time", at, &[elapsed], &[state.t]);
            // d/dθ (½ I θ̇²) = −dV/dθ, with θ̈ from the model; then Newton's equations of slider and rod.
            let a = MECHANISM.accelerations(state)[0];
            let [turning, sliding] = [phi, x].map(|z| z[1] * a + z[2] * w * w);
            let found = MECHANISM.outputs(state).force;
            // On the slider act −λx and the spring; moments of the rod are taken about its centre and about the pin.
            let along = -slider * sliding - k * x[0];
            compare(&mut figures, "force along", at, &[found.x], &[along]);
            let (s, c) = phi[0].sin_cos();
            let pin = MECHANISM.pin_acceleration(angle, w, a);
            let about_pin = m * l * l / 3.0 * turning;
            let weight = m * g * 0.5 * l * c;
            let carried = 0.5 * m * l * (-s * pin[0] - c * pin[1]);
            let across = -(about_pin + carried - weight + l * s * found.x) / (l * c);
            compare(&mut figures, "force across", at, &[found.y], &[across]);
        }
    }
    figures.finish();
}

impl SliderCrank {
    /// The acceleration of the pin of the crank.
    fn pin_acceleration(&self, theta: f64, rate: f64, acceleration: f64) -> [f64; 2] {
        let (sine, cosine) = theta.sin_cos();
        let square = rate * rate;
        [
            self.r * (-sine * acceleration - cosine * square),
            self.r * (cosine * acceleration - sine * square),
        ]
    }
}
