//! The motion of a heavy top, from its energies to a figure.
//!
//! `cargo run --release --example heavy_top`; with `-- --help` it lists what can be changed.

use std::fmt;
use std::io::{self, Write};
use std::process::ExitCode;

use clap::Parser;

use crate::comparison::comparison;
use crate::figure::figure;
use crate::files::Files;
use crate::motion::integrate;
use crate::nutation::Nutation;
use crate::options::Options;
use crate::record::records;
use crate::symmetric_top::SymmetricTop;

mod model;

mod checks;
mod options;

mod motion;
mod progress;
mod record;
mod turning_points;

mod cubic;
mod elliptic;
mod nutation;
mod symmetric_top;

mod comparison;
mod report;

mod files;
mod table;

mod figure;

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
    let top = options.top();
    say(report::equations());
    let motion = integrate(&top, options);
    let records = records(&top, &motion.states);
    let nutation = SymmetricTop::of(&top).and_then(|top| Nutation::through(&top, &options.start()));
    say(report::cost(&motion, options));
    say(report::constants(&top, &records));
    say(comparison(
        &top,
        &records,
        nutation.as_ref(),
        options.tolerance,
    ));
    let figure = figure(&options.summary(), &records, nutation.as_ref());
    say(files.write(&records, &figure)?);
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
