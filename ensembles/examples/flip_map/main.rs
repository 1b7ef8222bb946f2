//! How long a double pendulum takes until one of its links flips over, for a grid of starts at rest.
//!
//!     cargo run --release -p lagrangian-ensembles --features parquet --example flip_map
//!
//! The results are in a folder, chunk by chunk. Interrupt the program and start it again: it continues after the finished
//! chunks. `--shard 1/4` computes a quarter of them; with the feature `mpi`, `mpirun -n 4` shares them among ranks.
//! Whoever completes the folder draws the picture.

mod picture;

use std::error::Error;
use std::path::PathBuf;

use clap::Parser;
use indicatif::{ProgressBar, ProgressStyle};
use lagrangian::prelude::*;
#[cfg(feature = "mpi")]
use lagrangian_ensembles::mpi::{self, traits::Communicator as _};
use lagrangian_ensembles::{Axis, Column, Folder, Grid, Shard, Study};

/// Two equal particles on equal massless rods, angles from the downward vertical.
#[derive(Lagrangian, Clone, Debug)]
#[lagrangian(
    taylor,
    coordinates(theta[2]),
    define(
        p1 = l * [sin(theta[0]), -cos(theta[0])],
        p2 = p1 + l * [sin(theta[1]), -cos(theta[1])],
    ),
    kinetic = 0.5 * m * (dot(p1).norm_squared() + dot(p2).norm_squared()),
    potential = m * g * (p1.y + p2.y),
    // Zero where a link points upwards.
    event(first = cos(0.5 * theta[0]), second = cos(0.5 * theta[1])),
)]
struct DoublePendulum {
    m: f64,
    l: f64,
    g: f64,
}

/// How long a double pendulum takes until one of its links flips over.
#[derive(Parser)]
struct Arguments {
    /// The number of starts in each direction.
    #[arg(long, default_value_t = 200)]
    size: usize,
    /// The time after which a pendulum is given up, in s.
    #[arg(long, default_value_t = 20.0)]
    time: f64,
    /// The relative tolerance of the integration.
    #[arg(long, default_value_t = 1e-9)]
    tolerance: f64,
    /// The folder of the results.
    #[arg(long, default_value = "flip_map")]
    folder: PathBuf,
    /// The part of the results that this process computes, such as 2/4.
    #[arg(long)]
    shard: Option<Shard>,
    /// The number of threads; by default one for each core.
    #[arg(long)]
    threads: Option<usize>,
    /// The picture.
    #[arg(long, default_value = "flip_map.png")]
    image: PathBuf,
}

fn main() -> Result<(), Box<dyn Error>> {
    let arguments = Arguments::parse();
    #[cfg(feature = "mpi")]
    let (universe, _) = mpi::initialize_with_threading(mpi::Threading::Funneled)
        .ok_or("MPI could not be initialized")?;
    let folder = Folder::new(&arguments.folder);
    #[cfg(feature = "mpi")]
    let folder = folder.ranks(&universe.world());
    let folder = match arguments.shard {
        Some(shard) => folder.shard(shard),
        None => folder,
    };

    // The motion from (−θ₁, −θ₂) is the mirror image of that from (θ₁, θ₂): half of the starts are enough.
    let axis = |name: &str, low: f64| {
        Axis::linear(name, low, picture::LARGEST, arguments.size).unit("rad")
    };
    let starts = Grid::new([axis("theta1", 0.0), axis("theta2", -picture::LARGEST)]);
    let problem = |theta: [f64; 2]| {
        let pendulum = DoublePendulum {
            m: 1.0,
            l: 1.0,
            g: 9.81,
        };
        Problem::new(pendulum, State::new(0.0, theta, [0.0, 0.0]))
            .on(DoublePendulum::FIRST)
            .stop()
            .on(DoublePendulum::SECOND)
            .stop()
    };
    let method = Taylor::new().relative_tolerance(arguments.tolerance);
    let bar = ProgressBar::new(0).with_style(ProgressStyle::with_template(
        "{bar:40} {pos}/{len} members, {per_sec}, {eta} left",
    )?);
    let study = Study::new(starts, problem, arguments.time, method)
        .metadata(
            "model",
            "double pendulum of equal particles on equal rods, m = 1 kg, l = 1 m, g = 9.81 m/s²",
        )
        .each_member(|progress| {
            bar.set_length(progress.members as u64);
            bar.set_position(progress.ended as u64);
        });
    let study = match arguments.threads {
        Some(threads) => study.threads(threads),
        None => study,
    };
    // The time of the flip, missing where there is none.
    let results = study.write(folder, [Column::new("flip").unit("s")], |motion| {
        [if motion.reason == StopReason::Condition {
            motion.t
        } else {
            f64::NAN
        }]
    })?;
    bar.finish();

    #[cfg(feature = "mpi")]
    if universe.world().rank() != 0 {
        return Ok(());
    }
    if results.is_complete() {
        println!("{}", results.summary()?);
        picture::draw(&results.table()?, arguments.size, &arguments.image)?;
        println!("the picture is {}", arguments.image.display());
    } else {
        println!(
            "{} of {} members are finished",
            results.finished(),
            arguments.size * arguments.size
        );
    }
    Ok(())
}
