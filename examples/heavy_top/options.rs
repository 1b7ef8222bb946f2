//! The command line.

use std::path::PathBuf;

use clap::Parser;
use lagrangian::State;

use crate::model::HeavyTop;

/// The motion of a heavy top: a rigid body that turns about a fixed pivot under its weight.
#[derive(Clone, Debug, Parser)]
#[command(name = "heavy_top", allow_negative_numbers = true, after_help = AFTER_HELP)]
pub(crate) struct Options {
    /// First principal moment of inertia about the pivot [kg m²]
    #[arg(
        long,
        value_name = "INERTIA",
        default_value_t = 1.2,
        help_heading = "Body"
    )]
    pub(crate) i1: f64,

    /// Second principal moment of inertia about the pivot [kg m²] [default: as --i1]
    #[arg(long, value_name = "INERTIA", help_heading = "Body")]
    pub(crate) i2: Option<f64>,

    /// Moment of inertia about the axis of the top, the third principal axis [kg m²]
    #[arg(
        long,
        value_name = "INERTIA",
        default_value_t = 0.5,
        help_heading = "Body"
    )]
    pub(crate) i3: f64,

    /// Mass [kg]
    #[arg(short, long, default_value_t = 1.3, help_heading = "Body")]
    pub(crate) mass: f64,

    /// Distance from the pivot to the centre of mass [m]
    #[arg(
        short = 'l',
        long,
        value_name = "LENGTH",
        default_value_t = 0.4,
        help_heading = "Body"
    )]
    pub(crate) arm: f64,

    /// Acceleration of gravity [m/s²]
    #[arg(
        short,
        long,
        value_name = "ACCELERATION",
        default_value_t = 9.81,
        help_heading = "Body"
    )]
    pub(crate) gravity: f64,

    /// Initial tilt θ: 0 is upright, 180 hangs down, both excluded [degrees]
    #[arg(
        long,
        value_name = "ANGLE",
        default_value_t = 30.0,
        help_heading = "Start"
    )]
    pub(crate) tilt: f64,

    /// Initial spin ψ̇ [rad/s]
    #[arg(
        long,
        value_name = "RATE",
        allow_hyphen_values = true,
        default_value_t = 16.0,
        help_heading = "Start"
    )]
    pub(crate) spin: f64,

    /// Initial precession rate φ̇ [rad/s]
    #[arg(
        long,
        value_name = "RATE",
        allow_hyphen_values = true,
        default_value_t = 0.0,
        help_heading = "Start"
    )]
    pub(crate) precession: f64,

    /// Initial nutation rate θ̇ [rad/s]
    #[arg(
        long,
        value_name = "RATE",
        allow_hyphen_values = true,
        default_value_t = 0.0,
        help_heading = "Start"
    )]
    pub(crate) nutation: f64,

    /// Time span [s]
    #[arg(
        short,
        long,
        value_name = "SECONDS",
        default_value_t = 9.0,
        help_heading = "Integration"
    )]
    pub(crate) time: f64,

    /// Number of samples, both ends included
    #[arg(
        short = 'n',
        long,
        value_name = "COUNT",
        default_value_t = 901,
        help_heading = "Integration"
    )]
    pub(crate) samples: usize,

    /// Tolerance of the local error, relative and absolute
    #[arg(
        long,
        value_name = "ERROR",
        default_value = "1e-12",
        help_heading = "Integration"
    )]
    pub(crate) tolerance: f64,

    /// The folder that both files are written into.
    #[arg(
        help = "Folder for heavy_top.csv and heavy_top.svg; created if it does not exist",
        short,
        long,
        value_name = "FOLDER",
        default_value = ".",
        help_heading = "Output"
    )]
    pub(crate) output: PathBuf,
}

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

    /// The initial state.
    pub(crate) fn start(&self) -> State<f64, 3> {
        State::new(
            0.0,
            [0.0, self.tilt.to_radians(), 0.0],
            [self.precession, self.nutation, self.spin],
        )
    }

    /// The times of the samples.
    pub(crate) fn times(&self) -> Vec<f64> {
        // Counts up to a million are exact, and so is the last time.
        #[allow(clippy::cast_precision_loss)]
        let time = |k: usize| self.time * (k as f64 / (self.samples - 1) as f64);
        (0..self.samples).map(time).collect()
    }

    /// The parameters as the figure has them under its title.
    pub(crate) fn summary(&self) -> String {
        let HeavyTop {
            i1,
            i2,
            i3,
            m,
            g,
            l,
        } = self.top();
        let Self {
            tilt,
            spin,
            precession,
            nutation,
            ..
        } = self;
        format!(
            "I₁ = {i1}, I₂ = {i2}, I₃ = {i3} kg m²; m = {m} kg, l = {l} m, g = {g} m/s²; at the start: \
             tilt {tilt}°, spin {spin}, precession {precession}, nutation {nutation} rad/s"
        )
        .replace('-', "−")
    }
}
