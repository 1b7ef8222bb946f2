//! A pendulum with an encoder of 2000 counts per turn: velocity by differences, and by an observer.

use std::f64::consts::TAU;

use lagrangian::prelude::*;
use lagrangian_guide::{Curve, Figure};

#[derive(Lagrangian, Clone)]
#[lagrangian(
    taylor,
    coordinates(theta),
    kinetic = 0.5 * m * (l * dot(theta)).powi(2),
    potential = -m * g * l * cos(theta),
)]
struct Pendulum {
    m: f64,
    l: f64,
    g: f64,
}

const PERIOD: f64 = 1e-3;
const COUNT: f64 = TAU / 2000.0;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let pendulum = Pendulum {
        m: 1.0,
        l: 0.5,
        g: 9.81,
    };
    let motion = Problem::new(&pendulum, State::new(0.0, [1.0], [0.0]))
        .save(Every(PERIOD))
        .solve(2.0, Taylor::new())?;

    let mut last = 1.0;
    let mut estimate = State::new(0.0, [1.0], [0.0]);
    let mut errors = Vec::new();
    for x in &motion.samples()[1..] {
        let measured = (x.q[0] / COUNT).round() * COUNT;
        let difference = (measured - last) / PERIOD;
        last = measured;

        // Predicted by the model over the period, then corrected: both poles of the error are at 0.9.
        let acceleration = pendulum.accelerations(&estimate)[0];
        let predicted = estimate.q[0] + PERIOD * estimate.v[0];
        let innovation = measured - predicted;
        estimate.q[0] = predicted + 0.19 * innovation;
        estimate.v[0] += PERIOD * acceleration + 0.01 / PERIOD * innovation;

        errors.push([x.t, difference - x.v[0], estimate.v[0] - x.v[0]]);
    }

    let largest = |column: usize| errors.iter().map(|e| e[column].abs()).fold(0.0, f64::max);
    println!("largest error of the velocity in rad/s");
    println!("  by differences  {:.1}", largest(1));
    println!("  by the observer {:.2}", largest(2));
    let curve = |column: usize| errors.iter().map(|e| [e[0], e[column]]).collect();
    Figure {
        file: "encoder",
        x: "t in s",
        y: "error of the velocity in rad/s",
    }
    .draw(&[
        Curve {
            name: "differences",
            points: curve(1),
        },
        Curve {
            name: "observer",
            points: curve(2),
        },
    ])
}
