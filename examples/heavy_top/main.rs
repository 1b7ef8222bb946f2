//! The motion of a heavy top, from its energies to a figure.
//!
//! `cargo run --release --example heavy_top`; with `-- --help` it lists what can be changed.

use std::io::{self, Write};
use std::process::ExitCode;

use clap::Parser;

use crate::files::Files;
use crate::motion::integrate;
use crate::options::Options;

mod model;

mod options;

mod motion;
mod progress;

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
    options.body.check()?;
    let files = Files::create(&options.output)?;
    let top = options.body.top();
    say(&report::equations());
    let motion = integrate(&top, options).map_err(|error| error.to_string())?;
    let closed = top.nutation(&options.start.state());
    say(&report::cost(&motion, &options.integration));
    say(&report::constants(&top, &motion));
    say(&report::comparison(&top, &motion, closed.as_ref()));
    let figure = figure::figure(&options.summary(), &motion.samples, closed.as_ref());
    say(&files.write(&motion.samples, &figure)?);
    match motion.failure {
        None => Ok(()),
        Some(error) => Err(error.to_string()),
    }
}

/// Prints a paragraph. A reader who has gone away is no reason to stop before the files are written.
fn say(paragraph: &str) {
    let _ = writeln!(io::stdout(), "{paragraph}");
}

#[cfg(test)]
mod tests {
    /// Asserts that `value` differs from `expected` by at most `tolerance`, relative to the larger of
    /// |`expected`| and 1.
    #[track_caller]
    pub(crate) fn close(value: f64, expected: f64, tolerance: f64) {
        let difference = (value - expected).abs();
        assert!(
            difference <= tolerance * expected.abs().max(1.0),
            "{value} is not {expected}, by {difference:e}"
        );
    }
}
