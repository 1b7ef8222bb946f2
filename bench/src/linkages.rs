//! Rows of four-bar linkages of equal lengths over ten seconds, in which they pass ten singular configurations, for many lengths of
//! the first step, which decide where the others end: the greatest error beside a pendulum that moves as they do.

use std::fs;
use std::process::Command;

use crate::arguments::Arguments;
use crate::cargo::build_source;
use crate::command::output;
use crate::flags::Flags;
use crate::folders::Folders;
use crate::verdict::{Verdict, judge};

/// The program: linkages that the tests declare, and what is measured.
const SOURCE: [&str; 2] = [
    "tests/tests/constraints/four_bars.rs",
    "bench/models/linkages.rs",
];

/// The lengths of the first step, and those with `--quick`.
const FIRST_STEPS: [&str; 2] = ["20", "2"];

/// The largest error allowed in a coordinate, in 10⁻⁹ lengths of a crank: at tolerances of 10⁻¹² and above, and below 10⁻¹².
const LIMITS: [f64; 2] = [1.0, 10.0];

/// Measures, prints, and is an error where a limit is missed.
pub(crate) fn run(arguments: &Arguments) -> Result<(), String> {
    let folders = Folders::new()?;
    let mut source = String::new();
    for part in SOURCE {
        let path = folders.workspace.join(part);
        source += &fs::read_to_string(path).map_err(|error| error.to_string())?;
    }
    let built = build_source(&folders, "linkages", &source, Flags::Native)?;
    let first_steps = FIRST_STEPS[usize::from(arguments.quick)];
    let lines = output(Command::new(built.program()).arg(first_steps))?;
    let verdicts = lines.lines().map(verdict).collect::<Option<Vec<_>>>();
    judge(&verdicts.ok_or("a line that is none of the program's")?)
}

/// The verdict on a line of the program: linkages, tolerance, error, steps.
fn verdict(line: &str) -> Option<Verdict> {
    let mut words = line.split(' ');
    let (linkages, tolerance) = (words.next()?, words.next()?);
    let (error, steps) = (words.next()?.parse::<f64>().ok()?, words.next()?);
    let limit = LIMITS[usize::from(tolerance.parse::<f64>().ok()? < 1e-12)];
    Some(Verdict {
        what: format!("{linkages} linkages at {tolerance}, {steps} steps: greatest error in 1e-9"),
        figure: error / 1e-9,
        target: limit,
        limit,
    })
}
