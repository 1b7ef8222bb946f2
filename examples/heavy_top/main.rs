//! The motion of a heavy top, from its energies to a figure.
//!
//! `cargo run --release --example heavy_top`; with `-- --help` it lists what can be changed.

use std::fmt;
use std::io::{self, Write};
use std::process::ExitCode;

use clap::Parser;

use crate::files::Files;
use crate::motion::integrate;
use crate::nutation::Nutation;
use crate::options::Options;

mod model;

mod options;

mod motion;
mod progress;

mod cubic;
mod nutation;

mod figure;
mod files;
mod report;

fn main() -> ExitCode {
    match run(&Options::parse()) {
        Ok(()) => ExitCode::SUCCESS,
        Err(sentence) => {
            // If nobody listens there is nobody to tell.
            let _ = writeln!(io::stderr(), "error: {sentence}");
            ExitCode::FAILURE
        }
    }
}

/// Derived, integrated, compared, written. An integration that fails is reported as far as it came.
fn run(options: &Options) -> Result<(), String> {
    options.check()?;
    let files = Files::create(&options.output)?;
    let top = options.body.top();
    say(report::equations());
    let motion = integrate(&top, options);
    let closed = Nutation::through(&top, &options.start.state());
    say(report::cost(&motion, &options.integration));
    say(report::constants(&top, &motion));
    say(report::comparison(&top, &motion, closed.as_ref()));
    let figure = figure::figure(&options.summary(), &motion.samples, closed.as_ref());
    say(files.write(&motion.samples, &figure)?);
    match motion.failure {
        None => Ok(()),
        Some(error) => Err(error.to_string()),
    }
}

/// Prints a paragraph. A reader who has gone away is no reason to stop before the files are written.
fn say(paragraph: impl fmt::Display) {
    let _ = writeln!(io::stdout(), "{paragraph}");
}

/// Asserts that `value` differs from `expected` by at most `tolerance`, relative to the larger of
/// |`expected`| and 1.
#[cfg(test)]
#[track_caller]
fn close(value: f64, expected: f64, tolerance: f64) {
    let difference = (value - expected).abs();
    assert!(
        difference <= tolerance * expected.abs().max(1.0),
        "{value} is not {expected}, by {difference:e}"
    );
}

/// The symmetric top with the moments of inertia I and `I_s` and the moment m g l of its weight.
#[cfg(test)]
fn symmetric(transverse: f64, axial: f64, moment: f64) -> model::HeavyTop {
    model::HeavyTop {
        i1: transverse,
        i2: transverse,
        i3: axial,
        m: moment,
        g: 1.0,
        l: 1.0,
    }
}
