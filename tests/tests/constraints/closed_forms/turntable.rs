//! A ball on a turntable: its point of contact describes a circle, by 2/7 of the rate of the table.

use std::f64::consts::TAU;

use lagrangian::prelude::*;
use lagrangian_tests::Figures;
use nalgebra::{Vector2, Vector3};

use super::{by_both_methods, compare};

/// A homogeneous ball that rolls on a table that turns, its orientation a unit quaternion e.
///
/// On |e| = 1 its rotational energy is ½ I ω² = 2 I |ė|².
#[derive(Clone, Lagrangian)]
#[lagrangian(
    taylor,
    coordinates(p: Vector2, e: Vector4),
    define(
        axis = e.rows(1, 3),
        w = 2.0 * (e[0] * dot(axis) - dot(e[0]) * axis + axis.cross(dot(axis))),
        moment = 0.4 * m * r.powi(2),
    ),
    kinetic = 0.5 * m * dot(p).norm_squared() + 2.0 * moment * dot(e).norm_squared(),
    constraint(unit = e.norm_squared() - 1.0),
    nonholonomic(rolling = dot(p) - r * [w.y, -w.x] - table * [-p.y, p.x]),
    output(spin = w, friction = reaction(rolling)),
)]
struct BallOnTable {
    m: f64,
    r: f64,
    table: f64,
}

impl BallOnTable {
    /// The state of a ball that rolls at p with a velocity, and spins about the vertical.
    fn rolling(&self, p: Vector2<f64>, velocity: Vector2<f64>, spin: f64) -> State<f64, 6> {
        let slip = velocity - self.table * Vector2::new(-p.y, p.x);
        let w = Vector3::new(-slip.y / self.r, slip.x / self.r, spin);
        let q = [p.x, p.y, 1.0, 0.0, 0.0, 0.0];
        let v = [velocity.x, velocity.y, 0.0, 0.5 * w.x, 0.5 * w.y, 0.5 * w.z];
        State::new(0.0, q, v)
    }
}

#[test]
fn the_ball_runs_in_a_circle() {
    let ball = BallOnTable {
        m: 0.3,
        r: 0.1,
        table: 2.0,
    };
    let (p, velocity, spin) = (Vector2::new(0.4, -0.1), Vector2::new(0.05, 0.3), 0.7);
    let start = ball.rolling(p, velocity, spin);
    let rate = 2.0 / 7.0 * ball.table;
    // v = Ω′ ẑ × (p − middle).
    let middle = p - Vector2::new(velocity.y, -velocity.x) / rate;
    let mut figures = Figures::new();
    for (tolerance, states) in by_both_methods(&ball, start, (10.0 * TAU / rate, 100)) {
        for state in &states {
            let at = (state.t, tolerance);
            let turned = nalgebra::Rotation2::new(rate * state.t);
            let found = Vector2::new(state.q[0], state.q[1]);
            let expected = middle + turned * (p - middle);
            compare(
                &mut figures,
                "place",
                at,
                found.as_slice(),
                expected.as_slice(),
            );
            let (found, expected) = (Vector2::new(state.v[0], state.v[1]), turned * velocity);
            compare(
                &mut figures,
                "velocity",
                at,
                found.as_slice(),
                expected.as_slice(),
            );
            let outputs = ball.outputs(state);
            let expected = ball.m * rate * Vector2::new(-expected.y, expected.x);
            let found = outputs.friction;
            compare(
                &mut figures,
                "friction",
                at,
                found.as_slice(),
                expected.as_slice(),
            );
            compare(&mut figures, "spin", at, &[outputs.spin.z], &[spin]);
        }
    }
    figures.finish();
}
