//! The command line.

use std::path::PathBuf;

use clap::{Args, Parser, ValueEnum, value_parser};
use lagrangian::State;

use crate::model::HeavyTop;

/// The most samples that fit into memory without a second thought: 100 MB.
const MAX_SAMPLES: i64 = 1_000_000;

/// The motion of a heavy top: a rigid body that turns about a fixed pivot under its weight.
#[derive(Clone, Debug, Parser)]
#[command(name = "heavy_top", allow_negative_numbers = true, after_help = AFTER_HELP)]
pub(crate) struct Options {
    #[command(flatten, next_help_heading = "Body")]
    pub(crate) body: Body,
    #[command(flatten, next_help_heading = "Start")]
    pub(crate) start: Start,
    #[command(flatten, next_help_heading = "Integration")]
    pub(crate) integration: Integration,
    /// Folder for `heavy_top.csv` and `heavy_top.svg`.
    #[arg(short, long, value_name = "FOLDER", default_value = ".")]
    #[arg(help_heading = "Output", help = OUTPUT_HELP)]
    pub(crate) output: PathBuf,
}

/// The body.
#[derive(Clone, Debug, Args)]
pub(crate) struct Body {
    /// First principal moment of inertia about the pivot [kg m²]
    #[arg(long, value_name = "INERTIA", default_value_t = 1.2, value_parser = positive)]
    i1: f64,
    /// Second principal moment of inertia about the pivot [kg m²] [default: as --i1]
    #[arg(long, value_name = "INERTIA", value_parser = positive)]
    i2: Option<f64>,
    /// Moment of inertia about the axis of the top, the third principal axis [kg m²]
    #[arg(long, value_name = "INERTIA", default_value_t = 0.5, value_parser = positive)]
    i3: f64,
    /// Mass [kg]
    #[arg(short, long, default_value_t = 1.3, value_parser = positive)]
    mass: f64,
    /// Distance from the pivot to the centre of mass [m]
    #[arg(short = 'l', long, value_name = "LENGTH", default_value_t = 0.4, value_parser = not_negative)]
    arm: f64,
    /// Acceleration of gravity [m/s²]
    #[arg(short, long, value_name = "ACCELERATION", default_value_t = 9.81, value_parser = not_negative)]
    gravity: f64,
}

/// The initial state.
#[derive(Clone, Debug, Args)]
pub(crate) struct Start {
    /// Initial tilt θ: 0 is upright, 180 hangs down, both excluded [degrees]
    #[arg(long, value_name = "ANGLE", default_value_t = 30.0, value_parser = off_the_vertical)]
    tilt: f64,
    /// Initial spin ψ̇ [rad/s]
    #[arg(long, value_name = "RATE", default_value_t = 16.0, value_parser = finite)]
    #[arg(allow_hyphen_values = true)]
    spin: f64,
    /// Initial precession rate φ̇ [rad/s]
    #[arg(long, value_name = "RATE", default_value_t = 0.0, value_parser = finite)]
    #[arg(allow_hyphen_values = true)]
    precession: f64,
    /// Initial nutation rate θ̇ [rad/s]
    #[arg(long, value_name = "RATE", default_value_t = 0.0, value_parser = finite)]
    #[arg(allow_hyphen_values = true)]
    nutation: f64,
}

/// The integration.
#[derive(Clone, Debug, Args)]
pub(crate) struct Integration {
    /// Time span [s]
    #[arg(short, long, value_name = "SECONDS", default_value_t = 9.0, value_parser = positive)]
    pub(crate) time: f64,
    /// Number of samples, both ends included
    #[arg(short = 'n', long, value_name = "COUNT", default_value_t = 901)]
    #[arg(value_parser = value_parser!(u32).range(2..=MAX_SAMPLES))]
    samples: u32,
    /// Method of integration
    #[arg(long, value_enum, default_value_t = Method::Taylor)]
    pub(crate) method: Method,
    /// Tolerance of the local error, relative and absolute [default: 1e-12; of taylor, 2^-52]
    #[arg(long, value_name = "ERROR", value_parser = tolerance)]
    tolerance: Option<f64>,
    /// Largest step of runge-kutta, which ends one at each sample [s]
    #[arg(long, value_name = "SECONDS", default_value_t = 0.001, value_parser = positive)]
    pub(crate) step: f64,
}

/// The methods of integration.
#[derive(Clone, Copy, Debug, PartialEq, ValueEnum)]
pub(crate) enum Method {
    Taylor,
    Dop853,
    RungeKutta,
}

/// The help of `--output`, in which names of files have no backticks.
const OUTPUT_HELP: &str =
    "Folder for heavy_top.csv and heavy_top.svg; created if it does not exist";

/// What the help ends with; lines are broken for 80 columns.
const AFTER_HELP: &str = "\
The angles are z-x-z Euler angles: precession φ about the vertical, tilt θ of
the third principal axis from the vertical, spin ψ about that axis. The centre
of mass lies on that axis.

Prints the equations of motion, how well the constants of the motion were kept,
and for a symmetric top (i1 = i2) how close its nutation is to the closed form.

Examples, each after `cargo run --release --example heavy_top --`:
  --precession -0.5           a path with loops
  --i2 1                      a top without symmetry
  --tilt 100 --spin 5         nutation below the horizon
  --i1 1.5 --tilt 60 --spin 16 --precession 4
                              through the vertical, where the angles are singular";

impl Options {
    /// The parameters as the figure has them under its title.
    pub(crate) fn summary(&self) -> String {
        let (top, start) = (self.body.top(), &self.start);
        let body = format!(
            "I₁ = {}, I₂ = {}, I₃ = {} kg m²; m = {} kg, l = {} m, g = {} m/s²",
            top.i1, top.i2, top.i3, top.m, top.l, top.g
        );
        let start = format!(
            "tilt {}°, spin {}, precession {}, nutation {} rad/s",
            start.tilt, start.spin, start.precession, start.nutation
        );
        format!("{body}; at the start: {start}").replace('-', "−")
    }
}

impl Body {
    /// The body.
    pub(crate) fn top(&self) -> HeavyTop {
        HeavyTop {
            i1: self.i1,
            i2: self.i2.unwrap_or(self.i1),
            i3: self.i3,
            m: self.mass,
            g: self.gravity,
            l: self.arm,
        }
    }

    /// Why no rigid body has these moments of inertia, if none has.
    ///
    /// About the centre of mass (I₂ + I₃ − I₁)/2 is the sum of x² over the mass, and likewise for y and
    /// z; none of them is negative. About the pivot I₁ and I₂ are greater by m l² (2.2).
    pub(crate) fn check(&self) -> Result<(), String> {
        let (i1, i2, i3, l) = (self.i1, self.top().i2, self.i3, self.arm);
        let offset = self.mass * l * l;
        let [a, b, c] = [i1 - offset, i2 - offset, i3];
        let rounding = 1e-12 * (i1 + i2 + i3);
        if a.max(b).max(c) <= 0.5 * (a + b + c) + rounding {
            return Ok(());
        }
        Err(format!(
            "no rigid body has the moments of inertia {i1}, {i2} and {i3} kg m² about a pivot {l} m \
             from its centre of mass: those about the centre of mass would be {a:.4}, {b:.4} and \
             {c:.4} kg m², and the greatest may not exceed the sum of the others"
        ))
    }
}

impl Start {
    /// The initial state.
    pub(crate) fn state(&self) -> State<f64, 3> {
        let rates = [self.precession, self.nutation, self.spin];
        State::new(0.0, [0.0, self.tilt.to_radians(), 0.0], rates)
    }
}

impl Integration {
    /// The tolerance that is set, or that of the method: `Taylor` costs little more at full accuracy.
    pub(crate) fn tolerance(&self) -> f64 {
        let is_taylor = self.method == Method::Taylor;
        let of_method = if is_taylor { f64::EPSILON } else { 1e-12 };
        self.tolerance.unwrap_or(of_method)
    }

    /// The times of the samples. The last one is exact.
    pub(crate) fn times(&self) -> Vec<f64> {
        let last = f64::from(self.samples - 1);
        let time = |k| self.time * (f64::from(k) / last);
        (0..self.samples).map(time).collect()
    }
}

fn positive(text: &str) -> Result<f64, String> {
    let condition = "must be positive and finite";
    number(text, |x| x > 0.0 && x.is_finite(), condition)
}

fn not_negative(text: &str) -> Result<f64, String> {
    let condition = "must be finite and not negative; a hanging top has a --tilt over 90 degrees";
    number(text, |x| x >= 0.0 && x.is_finite(), condition)
}

fn finite(text: &str) -> Result<f64, String> {
    number(text, f64::is_finite, "must be finite")
}

fn off_the_vertical(text: &str) -> Result<f64, String> {
    let condition = "must lie between 0 and 180 degrees, both excluded: the Euler angles φ and ψ are \
                     not defined where the axis is vertical";
    number(text, |x| x > 0.0 && x < 180.0, condition)
}

fn tolerance(text: &str) -> Result<f64, String> {
    let condition = "must be from 2^-52, where rounding ends all progress, to 1e-2, where the result \
                     means nothing";
    number(text, |x| (f64::EPSILON..=1e-2).contains(&x), condition)
}

/// A number that meets a condition, or the condition.
fn number(text: &str, meets: impl Fn(f64) -> bool, condition: &str) -> Result<f64, String> {
    match text.parse() {
        Ok(value) if meets(value) => Ok(value),
        Ok(_) => Err(condition.into()),
        Err(error) => Err(error.to_string()),
    }
}

#[cfg(test)]
mod tests {
    use clap::Parser;

    use super::Options;

    /// The complaint about a command line, empty if there is none.
    fn complaint(line: &str) -> String {
        let words = std::iter::once("heavy_top").chain(line.split_whitespace());
        match Options::try_parse_from(words) {
            Ok(options) => options.body.check().err().unwrap_or_default(),
            Err(error) => error.to_string(),
        }
    }

    #[test]
    fn possible_values() {
        for line in [
            "",
            "--i1 1 --i2 0.9 --i3 0.6",
            "--precession -0.5 --nutation -1e-3 --spin -20",
            "--gravity 0 --arm 0",
            "--tilt 179.9 --tolerance 1e-3 -n 2 -t 1e-3",
            // A thin disc: the greatest moment is exactly the sum of the others.
            "--i1 15.234375 --i3 0.46875 -m 15 -l 1",
        ] {
            assert_eq!(complaint(line), "", "{line}");
        }
    }

    #[test]
    fn impossible_values() {
        for (line, option, condition) in [
            ("--i1 0", "'--i1 <INERTIA>'", "positive and finite"),
            ("--i2 -1", "'--i2 <INERTIA>'", "positive and finite"),
            ("--i3 nan", "'--i3 <INERTIA>'", "positive and finite"),
            ("--mass -1", "'--mass <MASS>'", "positive and finite"),
            ("--mass inf", "'--mass <MASS>'", "positive and finite"),
            ("--arm -0.1", "'--arm <LENGTH>'", "finite and not negative"),
            (
                "--gravity -9.81",
                "'--gravity <ACCELERATION>'",
                "finite and not negative",
            ),
            ("--tilt 0", "'--tilt <ANGLE>'", "between 0 and 180 degrees"),
            (
                "--tilt 180",
                "'--tilt <ANGLE>'",
                "between 0 and 180 degrees",
            ),
            ("--tilt -5", "'--tilt <ANGLE>'", "between 0 and 180 degrees"),
            (
                "--tilt nan",
                "'--tilt <ANGLE>'",
                "between 0 and 180 degrees",
            ),
            ("--spin inf", "'--spin <RATE>'", "must be finite"),
            (
                "--precession=-inf",
                "'--precession <RATE>'",
                "must be finite",
            ),
            ("--time 0", "'--time <SECONDS>'", "positive and finite"),
            ("--time soon", "'--time <SECONDS>'", "invalid float literal"),
            ("--step -1", "'--step <SECONDS>'", "positive and finite"),
            (
                "--samples 1",
                "'--samples <COUNT>'",
                "1 is not in 2..=1000000",
            ),
            (
                "--samples 2000000000",
                "'--samples <COUNT>'",
                "not in 2..=1000000",
            ),
            ("--tolerance 0", "'--tolerance <ERROR>'", "from 2^-52"),
            ("--tolerance 1", "'--tolerance <ERROR>'", "from 2^-52"),
            ("--tolerance 1e-20", "'--tolerance <ERROR>'", "from 2^-52"),
        ] {
            let found = complaint(line);
            let value = line.split([' ', '=']).next_back().unwrap_or_default();
            let start = format!("error: invalid value '{value}' for {option}: ");
            assert!(
                found.starts_with(&start) && found.contains(condition),
                "{line}: {found}"
            );
        }
    }

    #[test]
    fn impossible_bodies() {
        for line in [
            "--i1 1 --i2 2 --i3 0.9 --arm 0",
            "--i3 2.5 --arm 0",
            // Possible about the centre of mass, and not about a pivot away from it.
            "--i1 1 --i3 1.9",
        ] {
            let found = complaint(line);
            assert!(found.starts_with("no rigid body"), "{line}: {found}");
        }
    }
}
