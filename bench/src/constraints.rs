//! Andrews' squeezing mechanism, the standard test of constrained integrators (E. Hairer & G. Wanner, *Solving Ordinary
//! Differential Equations II*, 2nd edition (1996), VII.7): seven bodies that close three loops.
//!
//! Ours is the declared model (`models/squeezer.rs`). The peer is Radau5 of the crate `differential-equations`, with the
//! equations of the book by hand (`peers/squeezer.rs`) in each of their indices, with its best settings. Both integrate to 0.03 s at
//! tolerances, relative and absolute, from 1e-5 to 1e-14, in turn, and are compared at equal errors of coordinates and
//! velocities.

use std::fmt::Write as _;
use std::fs;
use std::ops::RangeInclusive;
use std::process::Command;

use crate::arguments::Arguments;
use crate::cargo::{build_dependencies_with, build_peer, build_source};
use crate::contest::{self, Entry, Rounds};
use crate::contestant::Contestant;
use crate::flags::Flags;
use crate::folders::Folders;
use crate::trajectories::error;
use crate::verdict::{Verdict, judge};
use crate::work_precision::curve::{Curve, Point};

/// The negative exponents of the tolerances.
const TOLERANCES: RangeInclusive<i32> = 5..=14;

/// The errors at which times are compared.
const COMPARED: [f64; 3] = [1e-8, 1e-9, 1e-10];

const END: f64 = 0.03;

/// The coordinates β θ γ φ δ Ω ε at rest (ibid., equation (7.11)).
const START: [f64; 7] = [
    -0.061_713_890_014_276_5,
    0.0,
    0.455_279_819_163_070_4,
    0.222_668_390_165_885_88,
    0.487_364_979_543_842_55,
    -0.222_668_390_165_885_88,
    1.230_547_444_549_821_2,
];

/// Coordinates and velocities at the end, by reduction to the one freedom: its speed by the energy, the loops by Newton's
/// method and the time by quadrature, with 28 digits. The published values differ by 1.4e-9 and 5e-7.
const REFERENCE: [f64; 14] = [
    15.810_771_195_153_707,
    -15.756_371_058_411_84,
    0.040_822_240_119_645_8,
    -0.534_730_116_342_079_6,
    0.524_409_965_879_954_1,
    0.534_730_116_342_079_6,
    1.048_080_741_041_938,
    1_139.920_302_259_106,
    -1_424.379_295_177_540_1,
    11.032_911_910_618_594,
    19.293_374_105_032_04,
    0.573_569_914_829_502_5,
    -19.293_374_105_032_04,
    0.323_179_149_249_130_9,
];

const OURS: &[&str] = &["Taylor", "Taylor 12", "Taylor 16", "Dop853"];

/// The equations that Radau5 solves: their index; whether their Jacobian is exact, or approximate as in the book; and whether the
/// error of accelerations and multipliers, which are no part of the state, is ignored.
const RADAU5: &[&str] = &[
    "index 1, exact",
    "index 1, exact, of state",
    "index 1, approximate, of state",
    "index 2, exact",
    "index 2, exact, of state",
    "index 2, approximate, of state",
    "index 3, exact",
    "index 3, exact, of state",
    "index 3, approximate",
    "index 3, approximate, of state",
];

/// Measures, prints, and is an error where a method of ours takes longer than Radau5.
pub(crate) fn run(arguments: &Arguments) -> Result<(), String> {
    let folders = Folders::new()?;
    eprintln!("building the model and the peer");
    build_dependencies_with(&folders, &[Flags::Native])?;
    let source = folders.workspace.join("bench/models/squeezer.rs");
    let source = fs::read_to_string(source).map_err(|error| error.to_string())?;
    let ours = build_source(&folders, "squeezer-declared", &source, Flags::Native)?;
    let peer = build_peer(&folders, "squeezer", &["squeezer_equations"])?;
    let mut contestants = [ours.start()?, Contestant::start(&mut Command::new(peer))?];
    let curves = measured(&mut contestants, Rounds::new(arguments.quick));
    print!("{}", table(&curves));
    judge(&verdicts(&curves))
}

/// The curves of our methods and of Radau5.
fn measured(contestants: &mut [Contestant], rounds: Rounds) -> [Vec<Curve>; 2] {
    let starts = [[START, [0.0; 7]].concat()];
    let mut entries = Vec::new();
    for (side, methods) in [OURS, RADAU5].into_iter().enumerate() {
        for method in methods {
            for digits in TOLERANCES {
                let entry = Entry::new(side, method, &starts, END);
                entries.push(entry.with_tolerance(10_f64.powi(-digits)));
            }
        }
    }
    contest::run(contestants, &mut entries, rounds);
    let curve = |name: &'static str| {
        let runs = entries
            .iter()
            .filter(|entry| entry.integration.method == name);
        Curve {
            name,
            points: runs.filter_map(point).collect(),
        }
    };
    [OURS, RADAU5].map(|methods| methods.iter().copied().map(curve).collect())
}

/// What a run shows, if it came to its end.
fn point(entry: &Entry) -> Option<Point> {
    let result = entry.result.as_ref()?;
    Some(Point {
        tolerance: entry.integration.tolerance?,
        seconds: result.seconds,
        error: error(result.states.first()?, &REFERENCE),
    })
}

/// Times by errors.
fn table(curves: &[Vec<Curve>]) -> String {
    let mut table = format!("{:<32}", "milliseconds to an error of");
    for error in COMPARED {
        let _ = write!(table, "{error:>10.0e}");
    }
    table += "\n";
    for curve in curves.iter().flatten() {
        let _ = write!(table, "{:<32}", curve.name);
        for error in COMPARED {
            let _ = write!(table, "{:>10.2}", 1e3 * curve.seconds_to(error));
        }
        table += "\n";
    }
    table
}

/// Each of our methods beside the fastest of the forms for Radau5.
fn verdicts([ours, theirs]: &[Vec<Curve>; 2]) -> Vec<Verdict> {
    let mut verdicts = Vec::new();
    for error in COMPARED {
        let seconds = |name: &str, curves: &[Curve]| {
            let curves = curves.iter().filter(|curve| curve.name.starts_with(name));
            let seconds = curves.map(|curve| curve.seconds_to(error));
            seconds.fold(f64::NAN, f64::min)
        };
        for name in ["Taylor", "Dop853"] {
            verdicts.push(Verdict {
                what: format!("{name} over Radau5 to an error of {error:.0e}"),
                figure: seconds(name, ours) / seconds("", theirs),
                target: 1.0,
                limit: 1.0,
            });
        }
    }
    verdicts
}
