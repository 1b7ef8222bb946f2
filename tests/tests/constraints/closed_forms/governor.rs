//! A flyball governor with springs and dampers, against an integration of its equations with 24 digits (`data/README.md`).

use lagrangian::prelude::*;
use lagrangian_tests::{Figures, array, governor, list, number};
use serde_json::Value;

use super::{TOLERANCE, by_both_methods, compare};

/// A spindle turns two balls in its plane, which is at the angle phi: each hangs on an arm without mass, and a link, which is a spring
/// beside a damper, of the length u without mass closes the loop to the sleeve at the height z on the spindle.
#[derive(Clone, Lagrangian)]
#[lagrangian(
    taylor,
    coordinates(phi, ball[2]: Vector3, u[2], z),
    define(sleeve = [0.0, 0.0, z], across = [-sin(phi), cos(phi), 0.0]),
    kinetic = 0.5 * i * dot(phi).powi(2) + 0.5 * s * dot(z).powi(2),
    kinetic = (0..2).map(|n| 0.5 * m * dot(ball[n]).norm_squared()).sum(),
    potential = s * g * z + (0..2).map(|n| m * g * ball[n].z + 0.5 * k * (u[n] - rest).powi(2)).sum(),
    dissipation = (0..2).map(|n| 0.5 * c * dot(u[n]).powi(2)).sum(),
    force(phi = torque),
    constraint(
        arm[n] = ball[n].norm() - l for n in 0..2,
        drive[n] = ball[n].dot(across) for n in 0..2,
        link[n] = (ball[n] - sleeve).norm() - u[n] for n in 0..2,
    ),
)]
struct Governor {
    m: f64,
    s: f64,
    i: f64,
    l: f64,
    g: f64,
    k: f64,
    rest: f64,
    c: f64,
    torque: f64,
}

/// What the constraints say at a sample, whose coordinates are the angles of the spindle and of the arms, and the height of the sleeve.
struct Expected {
    state: State<f64, 10>,
    accelerations: [f64; 10],
    multipliers: [f64; 6],
}

impl Governor {
    fn of(parameters: &Value) -> Self {
        let names = ["m", "s", "i", "l", "g", "k", "rest", "c", "torque"];
        let [m, s, i, l, g, k, rest, c, torque] = names.map(|name| number(&parameters[name]));
        #[rustfmt::skip]
        return Self { m, s, i, l, g, k, rest, c, torque };
    }

    fn expected(&self, sample: &Value) -> Expected {
        let [q, v, a] = ["q", "qd", "qdd"].map(|name| array::<4>(&sample[name]));
        let tensions: [f64; 2] = array(&sample["tensions"]);
        let mut coordinates = [[0.0; 10]; 3];
        let mut multipliers = [0.0; 6];
        for n in 0..2 {
            let ball = self.ball(n, [q, v, a]);
            let link = link_to([q[3], v[3], a[3]], ball);
            for order in 0..3 {
                coordinates[order][1 + 3 * n..][..3].copy_from_slice(ball[order].as_slice());
                coordinates[order][7 + n] = link[order];
            }
            let across = Vector3::new(-q[0].sin(), q[0].cos(), 0.0);
            multipliers[n] = -tensions[n];
            multipliers[2 + n] = self.m * across.dot(&ball[2]);
            multipliers[4 + n] = -self.k * (link[0] - self.rest) - self.c * link[1];
        }
        for (order, given) in [q, v, a].iter().enumerate() {
            coordinates[order][0] = given[0];
            coordinates[order][9] = given[3];
        }
        let [q, v, accelerations] = coordinates;
        Expected {
            state: State::new(number(&sample["t"]), q, v),
            accelerations,
            multipliers,
        }
    }

    /// A ball's position, velocity and acceleration, in cylindrical coordinates about the spindle. The second arm is on the other side.
    fn ball(&self, n: usize, [q, v, a]: [[f64; 4]; 3]) -> [Vector3<f64>; 3] {
        let outwards = if n == 0 { self.l } else { -self.l };
        let (sine, cosine) = q[1 + n].sin_cos();
        let (rate, second) = (v[1 + n], a[1 + n]);
        let bend = [sine, cosine * rate, cosine * second - sine * rate * rate];
        let [r, r1, r2] = bend.map(|x| outwards * x);
        let fall = [cosine, -sine * rate, -sine * second - cosine * rate * rate];
        let [height, climb, lift] = fall.map(|x| -self.l * x);
        let along = Vector3::new(q[0].cos(), q[0].sin(), 0.0);
        let across = Vector3::new(-q[0].sin(), q[0].cos(), 0.0);
        [
            r * along + height * Vector3::z(),
            r1 * along + r * v[0] * across + climb * Vector3::z(),
            (r2 - r * v[0] * v[0]) * along
                + (r * a[0] + 2.0 * r1 * v[0]) * across
                + lift * Vector3::z(),
        ]
    }
}

/// The length of a link between the sleeve and a ball, and its first and second rate; the height of the sleeve and the position of
/// the ball are given with their rates.
fn link_to(sleeve: [f64; 3], ball: [Vector3<f64>; 3]) -> [f64; 3] {
    let [d, d1, d2] = [0, 1, 2].map(|order| ball[order] - sleeve[order] * Vector3::z());
    let length = d.norm();
    let rate = d.dot(&d1) / length;
    let second = (d1.norm_squared() + d.dot(&d2) - rate * rate) / length;
    [length, rate, second]
}

#[test]
fn the_governor_follows_newtons_equations() {
    let document = governor();
    let governor = Governor::of(&document["params"]);
    let samples = list(&document["samples"]);
    let expected: Vec<_> = samples.iter().map(|x| governor.expected(x)).collect();
    let mut figures = Figures::new();
    for sample in &expected {
        check(&mut figures, &governor, &sample.state, sample, TOLERANCE);
    }
    let end = expected[4].state.t;
    for (tolerance, states) in by_both_methods(&governor, expected[0].state, (end, 8)) {
        for sample in &expected {
            let state = states.iter().find(|x| (x.t - sample.state.t).abs() < 1e-12);
            let state = state.expect("a sample at this time");
            check(&mut figures, &governor, state, sample, tolerance);
        }
    }
    figures.finish();
}

fn check(
    figures: &mut Figures,
    governor: &Governor,
    state: &State<f64, 10>,
    expected: &Expected,
    tolerance: f64,
) {
    let at = (state.t, tolerance);
    let accelerations = governor.accelerations(state);
    let multipliers = governor.multipliers(state);
    let exact = &expected.state;
    let mut compare = |what, found, expected| compare(figures, what, at, found, expected);
    compare("q", state.q.as_slice(), exact.q.as_slice());
    compare("qd", state.v.as_slice(), exact.v.as_slice());
    compare("qdd", accelerations.as_slice(), &expected.accelerations);
    compare("lambda", multipliers.as_slice(), &expected.multipliers);
}
