//! The command line.

use std::path::PathBuf;

use clap::{Args, Parser, ValueEnum};
use lagrangian::State;

use crate::model::HeavyTop;

/// The most samples that fit into memory without a second thought: 100 MB.
const MAX_SAMPLES: usize = 1_000_000;

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
    #[arg(long, value_name = "INERTIA", default_value_t = 1.2)]
    i1: f64,
    /// Second principal moment of inertia about the pivot [kg m²] [default: as --i1]
    #[arg(long, value_name = "INERTIA")]
    i2: Option<f64>,
    /// Moment of inertia about the axis of the top, the third principal axis [kg m²]
    #[arg(long, value_name = "INERTIA", default_value_t = 0.5)]
    i3: f64,
    /// Mass [kg]
    #[arg(short, long, default_value_t = 1.3)]
    mass: f64,
    /// Distance from the pivot to the centre of mass [m]
    #[arg(short = 'l', long, value_name = "LENGTH", default_value_t = 0.4)]
    arm: f64,
    /// Acceleration of gravity [m/s²]
    #[arg(short, long, value_name = "ACCELERATION", default_value_t = 9.81)]
    gravity: f64,
}

/// The initial state.
#[derive(Clone, Debug, Args)]
pub(crate) struct Start {
    /// Initial tilt θ: 0 is upright, 180 hangs down, both excluded [degrees]
    #[arg(long, value_name = "ANGLE", default_value_t = 30.0)]
    tilt: f64,
    /// Initial spin ψ̇ [rad/s]
    #[arg(long, value_name = "RATE", default_value_t = 16.0)]
    #[arg(allow_hyphen_values = true)]
    spin: f64,
    /// Initial precession rate φ̇ [rad/s]
    #[arg(long, value_name = "RATE", default_value_t = 0.0)]
    #[arg(allow_hyphen_values = true)]
    precession: f64,
    /// Initial nutation rate θ̇ [rad/s]
    #[arg(long, value_name = "RATE", default_value_t = 0.0)]
    #[arg(allow_hyphen_values = true)]
    nutation: f64,
}

/// The integration.
#[derive(Clone, Debug, Args)]
pub(crate) struct Integration {
    /// Time span [s]
    #[arg(short, long, value_name = "SECONDS", default_value_t = 9.0)]
    pub(crate) time: f64,
    /// Number of samples, both ends included
    #[arg(short = 'n', long, value_name = "COUNT", default_value_t = 901)]
    samples: usize,
    /// Method of integration
    #[arg(long, value_enum, default_value_t = Method::Taylor)]
    pub(crate) method: Method,
    /// Tolerance of the local error, relative and absolute [default: 1e-12; of taylor, 2^-52]
    #[arg(long, value_name = "ERROR")]
    tolerance: Option<f64>,
    /// Largest step of runge-kutta, which ends one at each sample [s]
    #[arg(long, value_name = "SECONDS", default_value_t = 0.001)]
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
    /// The first thing that is wrong with the options, in one sentence. A body has mass and inertia, gravity points down, Euler
    /// angles need a third axis that is not vertical, and the integration must be possible, and end.
    pub(crate) fn check(&self) -> Result<(), String> {
        let (body, start, integration) = (&self.body, &self.start, &self.integration);
        positive("--i1", body.i1)?;
        positive("--i2", body.top().i2)?;
        positive("--i3", body.i3)?;
        positive("--mass", body.mass)?;
        for (name, value) in [("--arm", body.arm), ("--gravity", body.gravity)] {
            require(value >= 0.0 && value.is_finite(), || {
                format!(
                    "{name} must be finite and not negative, and is {value}; a top that hangs has a \
                     --tilt over 90 degrees"
                )
            })?;
        }
        body.check_inertias()?;
        let tilt = start.tilt;
        require(tilt > 0.0 && tilt < 180.0, || {
            format!(
                "--tilt must lie between 0 and 180 degrees, both excluded, and is {tilt}: the Euler \
                 angles φ and ψ are not defined where the axis is vertical"
            )
        })?;
        let names = ["--precession", "--nutation", "--spin"];
        for (name, value) in names.iter().zip(&start.state().v) {
            require(value.is_finite(), || {
                format!("{name} must be finite, and is {value}")
            })?;
        }
        positive("--time", integration.time)?;
        positive("--step", integration.step)?;
        let (samples, tolerance) = (integration.samples, integration.tolerance());
        require((2..=MAX_SAMPLES).contains(&samples), || {
            format!("--samples must be from 2 to {MAX_SAMPLES}, and is {samples}")
        })?;
        require((f64::EPSILON..=1e-2).contains(&tolerance), || {
            format!(
                "--tolerance must be from 2^-52, where rounding ends all progress, to 1e-2, where the \
                 result means nothing, and is {tolerance}"
            )
        })
    }

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

    /// About the centre of mass (I₂ + I₃ − I₁)/2 is the sum of x² over the mass, and likewise for y and
    /// z; none of them is negative. About the pivot I₁ and I₂ are greater by m l² (2.2).
    fn check_inertias(&self) -> Result<(), String> {
        let (i1, i2, i3, l) = (self.i1, self.top().i2, self.i3, self.arm);
        let offset = self.mass * l * l;
        let [a, b, c] = [i1 - offset, i2 - offset, i3];
        let rounding = 1e-12 * (i1 + i2 + i3);
        require(a.max(b).max(c) <= 0.5 * (a + b + c) + rounding, || {
            format!(
                "no rigid body has the moments of inertia {i1}, {i2} and {i3} kg m² about a pivot {l} m \
                 from its centre of mass: those about the centre of mass would be {a:.4}, {b:.4} and \
                 {c:.4} kg m², and the greatest may not exceed the sum of the others"
            )
        })
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
        self.tolerance.unwrap_or(match self.method {
            Method::Taylor => f64::EPSILON,
            _ => 1e-12,
        })
    }

    /// The times of the samples.
    pub(crate) fn times(&self) -> Vec<f64> {
        // Counts up to a million are exact, and so is the last time.
        #[allow(clippy::cast_precision_loss)]
        let time = |k: usize| self.time * (k as f64 / (self.samples - 1) as f64);
        (0..self.samples).map(time).collect()
    }
}

/// A complaint about a number that must be positive, and is not.
fn positive(name: &str, value: f64) -> Result<(), String> {
    require(value > 0.0 && value.is_finite(), || {
        format!("{name} must be positive and finite, and is {value}")
    })
}

/// A complaint unless something holds.
fn require(holds: bool, complaint: impl FnOnce() -> String) -> Result<(), String> {
    if holds { Ok(()) } else { Err(complaint()) }
}

#[cfg(test)]
mod tests {
    use clap::Parser;

    use super::Options;

    /// The complaint about a command line, empty if there is none.
    fn complaint(line: &str) -> String {
        let words = std::iter::once("heavy_top").chain(line.split_whitespace());
        Options::try_parse_from(words)
            .expect("numbers where numbers belong")
            .check()
            .err()
            .unwrap_or_default()
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
        for (line, start) in [
            ("--i1 0", "--i1 must be positive"),
            ("--i2 -1", "--i2 must be positive"),
            ("--i3 nan", "--i3 must be positive"),
            ("--mass -1", "--mass must be positive"),
            ("--mass inf", "--mass must be positive"),
            ("--arm -0.1", "--arm must be finite and not negative"),
            (
                "--gravity -9.81",
                "--gravity must be finite and not negative",
            ),
            ("--i1 1 --i2 2 --i3 0.9 --arm 0", "no rigid body"),
            ("--i3 2.5 --arm 0", "no rigid body"),
            // Possible about the centre of mass, and not about a pivot away from it.
            ("--i1 1 --i3 1.9", "no rigid body"),
            ("--tilt 0", "--tilt must lie between"),
            ("--tilt 180", "--tilt must lie between"),
            ("--tilt -5", "--tilt must lie between"),
            ("--tilt nan", "--tilt must lie between"),
            ("--spin inf", "--spin must be finite"),
            ("--time 0", "--time must be positive"),
            ("--step -1", "--step must be positive"),
            ("--samples 1", "--samples must be from 2"),
            ("--samples 2000000000", "--samples must be from 2"),
            ("--tolerance 0", "--tolerance must be from"),
            ("--tolerance 1", "--tolerance must be from"),
            ("--tolerance 1e-20", "--tolerance must be from"),
        ] {
            let found = complaint(line);
            assert!(found.starts_with(start), "{line}: {found:?}");
        }
    }
}
