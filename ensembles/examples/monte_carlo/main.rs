//! A heavy top whose inertia is only known within tolerances: how much its nutation varies, and which parameter matters.
//!
//!     cargo run --release -p lagrangian-ensembles --example monte_carlo
//!
//! Draws the bands that contain 50 and 90 percent of the tops, and a histogram of the largest tilt.

mod picture;

use std::error::Error;
use std::path::PathBuf;

use clap::Parser;
use indicatif::ProgressBar;
use lagrangian::prelude::*;
use lagrangian_ensembles::{Column, Parameter, Sample, Study};

/// A heavy top with a fixed point; z-x-z Euler angles, moments of inertia about the fixed point.
#[derive(Lagrangian, Clone, Debug)]
#[lagrangian(
    taylor,
    coordinates(phi, theta, psi),
    define(
        w1 = dot(phi) * sin(theta) * sin(psi) + dot(theta) * cos(psi),
        w2 = dot(phi) * sin(theta) * cos(psi) - dot(theta) * sin(psi),
        w3 = dot(phi) * cos(theta) + dot(psi),
    ),
    kinetic = 0.5 * (i1 * w1.powi(2) + i2 * w2.powi(2) + i3 * w3.powi(2)),
    potential = m * g * l * cos(theta),
)]
struct HeavyTop {
    i1: f64,
    i2: f64,
    i3: f64,
    m: f64,
    g: f64,
    l: f64,
}

/// How much the nutation of a heavy top varies when its inertia is uncertain.
#[derive(Parser)]
struct Arguments {
    /// The number of tops.
    #[arg(long, default_value_t = 4096)]
    members: usize,
    /// The seed of the sample.
    #[arg(long, default_value_t = 1)]
    seed: u64,
    /// The picture.
    #[arg(long, default_value = "monte_carlo.png")]
    image: PathBuf,
}

/// The number of times at which the bands are computed, and their distance in s.
const TIMES: usize = 200;
const SPACING: f64 = 0.01;

fn main() -> Result<(), Box<dyn Error>> {
    let arguments = Arguments::parse();
    let inertias = Sample::new(
        arguments.members,
        [
            Parameter::normal("I1", 1.2, 0.01).unit("kg m²"),
            Parameter::normal("I2", 1.2, 0.01).unit("kg m²"),
            Parameter::normal("I3", 0.5, 0.01).unit("kg m²"),
            Parameter::normal("m", 1.3, 0.002).unit("kg"),
            Parameter::normal("l", 0.4, 0.002).unit("m"),
        ],
    )
    .sobol()
    .seed(arguments.seed);
    let problem = |[i1, i2, i3, m, l]: [f64; 5]| {
        let top = HeavyTop {
            i1,
            i2,
            i3,
            m,
            g: 9.81,
            l,
        };
        Problem::new(top, State::new(0.0, [0.0, 0.5, 0.0], [0.3, 0.0, 20.0])).save(Every(SPACING))
    };
    let bar = ProgressBar::new(arguments.members as u64);
    #[allow(clippy::cast_precision_loss)] // There are few.
    let end = SPACING * TIMES as f64;
    let study = Study::new(inertias, problem, end, Taylor::new())
        .each_member(|progress| bar.set_position(progress.ended as u64));

    // The tilt at each time, and its maximum.
    let tilts: [Column; TIMES + 1] = std::array::from_fn(|time| match time {
        TIMES => Column::new("largest tilt")
            .unit("rad")
            .histogram(0.52, 0.54, 40),
        _ => Column::new(format!("tilt {time}")).unit("rad"),
    });
    let summary = study.summary(tilts, |motion| {
        let mut tilts = [0.5; TIMES + 1];
        for (tilt, sample) in tilts.iter_mut().zip(&motion.samples()[1..]) {
            *tilt = sample.q[HeavyTop::THETA];
        }
        tilts[TIMES] = tilts.iter().copied().fold(0.0, f64::max);
        tilts
    })?;
    bar.finish();
    drop(study);

    let largest = summary
        .column("largest tilt")
        .ok_or("there is no such column")?;
    println!(
        "{} tops, largest tilt {:.4} ± {:.4} rad, between {:.4} and {:.4}; it follows from",
        summary.members(),
        largest.mean(),
        largest.standard_deviation(),
        largest.min().unwrap_or_default().0,
        largest.max().unwrap_or_default().0,
    );
    // The part of the variance that a linear function of one parameter explains.
    let parameters = ["I1", "I2", "I3", "m", "l"];
    let parts = parameters.map(|name| {
        let correlation = summary
            .correlation(name, "largest tilt")
            .unwrap_or_default();
        (name, correlation.powi(2))
    });
    for (name, part) in parts {
        println!("  {name:3} {:5.1} %", 100.0 * part);
    }
    picture::draw(&summary, SPACING, &parts, &arguments.image)?;
    println!("the picture is {}", arguments.image.display());
    Ok(())
}
