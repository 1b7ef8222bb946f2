//! Chaplygin's sleigh, against its solution in hyperbolic functions.

use lagrangian::prelude::*;
use lagrangian_tests::{Figures, list, number, references};
use nalgebra::Vector2;

use super::{TOLERANCE, by_both_methods, compare};

/// A sleigh on a knife edge at p, with its centre of gravity ahead of the edge.
#[derive(Clone, Lagrangian)]
#[lagrangian(
    taylor,
    coordinates(p: Vector2, theta),
    define(
        forward = [cos(theta), sin(theta)],
        left = [-sin(theta), cos(theta)],
    ),
    kinetic = 0.5 * m * dot(p + a * forward).norm_squared() + 0.5 * j * dot(theta).powi(2),
    nonholonomic(edge = dot(p).dot(left)),
    output(speed = dot(p).dot(forward), push = reaction(edge)),
)]
struct KnifeEdge {
    m: f64,
    j: f64,
    a: f64,
}

/// v = v∞ tanh(k t + c) and ω = √(m/J) v∞ sech(k t + c) with J = j + m a² and k = m a v∞/J.
struct Solution {
    final_speed: f64,
    ratio: f64,
    rate: f64,
    phase: f64,
    angle: f64,
}

impl Solution {
    fn new(sleigh: &KnifeEdge, angle: f64, speed: f64, turning: f64) -> Self {
        let moment = sleigh.j + sleigh.m * sleigh.a * sleigh.a;
        let ratio = (sleigh.m / moment).sqrt();
        let final_speed = speed.hypot(turning / ratio);
        Self {
            final_speed,
            ratio,
            rate: ratio * ratio * sleigh.a * final_speed,
            phase: (speed * ratio / turning).asinh(),
            angle,
        }
    }

    /// The angle, the speed and the rate of turning.
    fn at(&self, t: f64) -> [f64; 3] {
        let phase = self.rate * t + self.phase;
        let gudermannian = |x: f64| x.sinh().atan();
        let turned = gudermannian(phase) - gudermannian(self.phase);
        [
            self.angle + self.ratio * self.final_speed / self.rate * turned,
            self.final_speed * phase.tanh(),
            self.ratio * self.final_speed / phase.cosh(),
        ]
    }
}

#[test]
fn the_sleigh_turns_until_it_runs_straight() {
    let sleigh = KnifeEdge {
        m: 2.0,
        j: 0.3,
        a: 0.25,
    };
    // Backwards at first: the centre of gravity runs ahead of the edge in the end.
    let (angle, speed, turning) = (0.3, -0.8, 1.5);
    let solution = Solution::new(&sleigh, angle, speed, turning);
    let along = speed * Vector2::new(angle.cos(), angle.sin());
    let start = State::new(0.0, [0.1, -0.2, angle], [along.x, along.y, turning]);
    let mut figures = Figures::new();
    for (tolerance, states) in by_both_methods(&sleigh, start, (6.0, 60)) {
        for state in &states {
            let at = (state.t, tolerance);
            let expected = solution.at(state.t);
            let outputs = sleigh.outputs(state);
            let found = [state.q[KnifeEdge::THETA], outputs.speed];
            compare(&mut figures, "angle, speed", at, &found, &expected[..2]);
            let found = state.v[KnifeEdge::THETA];
            compare(&mut figures, "turning", at, &[found], &expected[2..]);
            // The force that keeps the centre on its path, m (v ω + a ω̇).
            let [_, v, w] = expected;
            let rate = -solution.ratio * solution.ratio * sleigh.a * v * w;
            let push = sleigh.m * (v * w + sleigh.a * rate);
            compare(&mut figures, "push", at, &[outputs.push], &[push]);
        }
    }
    figures.finish();
}

#[test]
fn the_sleigh_meets_the_listed_values() {
    let mut figures = Figures::new();
    let document = references();
    let forms = list(&document["closed_forms"]).iter();
    for form in forms.filter(|form| form["kind"] == "chaplygin_sleigh") {
        let [m, j, a, v, w] = ["m", "j", "a", "v0", "omega0"].map(|name| number(&form[name]));
        let sleigh = KnifeEdge { m, j, a };
        let solution = Solution::new(&sleigh, 0.0, v, w);
        let start = State::new(0.0, [0.0; 3], [v, 0.0, w]);
        for sample in list(&form["samples"]) {
            let [t, v, w] = ["t", "v", "omega"].map(|name| number(&sample[name]));
            let end = Problem::new(&sleigh, start).solve(t, Taylor::new());
            let end = end.expect("a motion");
            let found = [sleigh.outputs(&end).speed, end.v[KnifeEdge::THETA]];
            let at = (t, TOLERANCE);
            compare(&mut figures, "motion", at, &found, &[v, w]);
            compare(&mut figures, "formula", at, &solution.at(t)[1..], &[v, w]);
        }
    }
    figures.finish();
}
