//! A double pendulum, sampled every 10 ms.

use lagrangian::prelude::*;
use lagrangian_guide::{Curve, Figure};

#[derive(Lagrangian)]
#[lagrangian(
    taylor,
    coordinates(a, b),
    define(
        p = l * [sin(a), -cos(a)],
        q = p + l * [sin(b), -cos(b)],
    ),
    kinetic = 0.5 * m * (dot(p).norm_squared() + dot(q).norm_squared()),
    potential = m * g * (p.y + q.y),
    output(tip = q),
)]
struct DoublePendulum {
    m: f64,
    l: f64,
    g: f64,
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let pendulum = DoublePendulum {
        m: 1.0,
        l: 1.0,
        g: 9.81,
    };
    let start = State::new(0.0, [1.5, 2.0], [0.0, 0.0]);
    let motion = Problem::new(&pendulum, start)
        .save(Every(0.01))
        .solve(5.0, Taylor::new())?;
    let energy = pendulum.energy(&start);
    let drift = motion
        .samples()
        .iter()
        .map(|x| pendulum.energy(x) / energy - 1.0);
    println!("{} samples", motion.samples().len());
    println!(
        "energy kept to {:.0e}",
        drift.fold(0.0_f64, |most, d| most.max(d.abs()))
    );
    let angles = |i: usize| motion.samples().iter().map(|x| [x.t, x.q[i]]).collect();
    Figure {
        file: "simulate",
        x: "t in s",
        y: "angle in rad",
    }
    .draw(&[
        Curve {
            name: "a",
            points: angles(0),
        },
        Curve {
            name: "b",
            points: angles(1),
        },
    ])
}
