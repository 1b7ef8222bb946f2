//! Work and precision: the error at t = 1000 against CPU time, of our integrators and of their peers.
//!
//! Each method integrates at tolerances, relative and absolute, from 1e-6 to 1e-15. The peers have equations by hand
//! with constants folded; ours are the declared models. Errors are those against our method in double-double, which
//! `--taylor` compares with references.

pub(crate) mod curve;
mod figure;

use std::fmt::Write as _;
use std::ops::RangeInclusive;
use std::path::PathBuf;
use std::process::Command;

use crate::arguments::Arguments;
use crate::cargo::{build, build_peer};
use crate::contest::{self, Entry, Rounds};
use crate::contestant::Contestant;
use crate::declaration::Calls;
use crate::flags::Flags;
use crate::folders::{Folders, create, write};
use crate::model::Model;
use crate::peers::{heyoka, skipped};
use crate::trajectories::{END, Trajectory, error};
use crate::verdict::{Verdict, judge};

use curve::{Curve, Point};

/// The negative exponents of the tolerances.
const TOLERANCES: RangeInclusive<i32> = 6..=15;

/// The error to which CPU times are compared.
const COMPARED: f64 = 1e-9;

/// Which contestants there are: ours, and those that can be had.
struct Sides {
    folders: Folders,
    python: Option<crate::python::Python>,
    solvers: Option<PathBuf>,
}

/// A method: its name in the figure, its contestant and what that calls it.
#[derive(Clone, Copy)]
struct Method {
    name: &'static str,
    side: Side,
    called: &'static str,
}

#[derive(Clone, Copy, PartialEq, Eq)]
enum Side {
    Ours,
    Heyoka,
    Solvers,
}

const METHODS: [Method; 8] = [
    Method::new("Taylor, order 12", Side::Ours, "Taylor 12"),
    Method::new("Taylor, order 16", Side::Ours, "Taylor 16"),
    Method::new("Taylor, default order", Side::Ours, "Taylor"),
    Method::new("Dop853", Side::Ours, "Dop853"),
    Method::new("heyoka", Side::Heyoka, "hand"),
    Method::new("heyoka, fast math", Side::Heyoka, "hand, fast math"),
    Method::new("ode_solvers", Side::Solvers, "ode_solvers"),
    Method::new(
        "differential-equations",
        Side::Solvers,
        "differential-equations",
    ),
];

impl Method {
    const fn new(name: &'static str, side: Side, called: &'static str) -> Self {
        Self { name, side, called }
    }
}

/// What is found of a model.
pub(crate) struct Panel {
    model: Model,
    curves: Vec<Curve>,
}

/// Measures, prints, writes the figure, and is an error where a limit is missed.
pub(crate) fn run(arguments: &Arguments) -> Result<(), String> {
    let folders = Folders::new()?;
    let python = heyoka(&folders)
        .map_err(|error| skipped("heyoka", &error))
        .ok();
    let solvers = build_peer(&folders, "solvers", &[])
        .map_err(|error| skipped("ode_solvers and differential-equations", &error))
        .ok();
    let sides = Sides {
        folders,
        python,
        solvers,
    };
    let mut panels = Vec::new();
    let mut verdicts = Vec::new();
    for &model in &arguments.models {
        eprintln!("{model}: deriving, compiling, measuring");
        let panel = sides.panel(model, arguments.quick)?;
        print!("{}", panel.table());
        verdicts.extend(panel.verdicts());
        panels.push(panel);
    }
    let folder = sides.folders.workspace.join("docs");
    create(&folder)?;
    write(&folder.join("work_precision.svg"), &figure::svg(&panels))?;
    judge(&verdicts)
}

impl Sides {
    fn panel(&self, model: Model, quick: bool) -> Result<Panel, String> {
        let trajectory = Trajectory::of(&self.folders, model)?;
        let starts = [trajectory.start.clone()];
        let mut contestants =
            vec![build(&self.folders, model, Calls::Integrate, Flags::Native)?.start()?];
        let mut there = vec![Side::Ours];
        let model_name = model.to_string();
        if let Some(python) = &self.python {
            contestants.push(python.start("heyoka_taylor.py", &[&model_name])?);
            there.push(Side::Heyoka);
        }
        if let Some(solvers) = &self.solvers {
            contestants.push(Contestant::start(Command::new(solvers).arg(&model_name))?);
            there.push(Side::Solvers);
        }
        let mut entries = Vec::new();
        let mut names = Vec::new();
        for method in METHODS {
            let Some(side) = there.iter().position(|side| *side == method.side) else {
                continue;
            };
            for digits in TOLERANCES {
                let tolerance = 10_f64.powi(-digits);
                let entry = Entry::new(side, method.called, &starts, END);
                entries.push(entry.with_tolerance(tolerance));
                names.push(method.name);
            }
        }
        contest::run(&mut contestants, &mut entries, Rounds::new(quick));
        let mut curves: Vec<Curve> = Vec::new();
        for (name, entry) in names.into_iter().zip(&entries) {
            let Some(result) = &entry.result else {
                continue;
            };
            if curves.last().is_none_or(|curve| curve.name != name) {
                curves.push(Curve {
                    name,
                    points: Vec::new(),
                });
            }
            let point = Point {
                tolerance: entry.integration.tolerance.unwrap_or(f64::NAN),
                seconds: result.seconds,
                error: error(&result.states[0], &trajectory.declared_end),
            };
            if let Some(curve) = curves.last_mut() {
                curve.points.push(point);
            }
        }
        Ok(Panel { model, curves })
    }
}

impl Panel {
    /// Errors and times by tolerance.
    fn table(&self) -> String {
        let mut table = format!(
            "\n{}: CPU time in ms and error, at tolerances\n  {:<24}",
            self.model, ""
        );
        for digits in TOLERANCES {
            let _ = write!(table, "{:>14}", format!("1e-{digits}"));
        }
        for curve in &self.curves {
            let _ = write!(table, "\n  {:<24}", curve.name);
            for point in &curve.points {
                let cell = format!("{:.2} {:.0e}", point.seconds * 1e3, point.error);
                let _ = write!(table, "{cell:>14}");
            }
        }
        table += "\n  CPU time in ms to an error of 1e-9:\n";
        for curve in &self.curves {
            let milliseconds = curve.seconds_to(COMPARED) * 1e3;
            let _ = writeln!(table, "  {:<24} {milliseconds:.2}", curve.name);
        }
        table
    }

    /// The fewest seconds to an error among curves whose names begin so.
    fn seconds_to(&self, error: f64, name: &str) -> f64 {
        let curves = self
            .curves
            .iter()
            .filter(|curve| curve.name.starts_with(name));
        curves
            .map(|curve| curve.seconds_to(error))
            .fold(f64::NAN, f64::min)
    }

    fn verdicts(&self) -> Vec<Verdict> {
        let seconds = |name| self.seconds_to(COMPARED, name);
        let mut pairs = vec![("Taylor", "heyoka", 0.7)];
        if self.model == Model::SymmetricTop {
            pairs.push(("Dop853", "ode_solvers", 1.0));
        }
        let verdict = |(ours, theirs, target)| {
            let figure = seconds(ours) / seconds(theirs);
            // Without the peer there is nothing to judge.
            seconds(theirs).is_finite().then(|| Verdict {
                what: format!("{}, {ours} over {theirs} to an error of 1e-9", self.model),
                figure,
                target,
                limit: 1.0,
            })
        };
        pairs.into_iter().filter_map(verdict).collect()
    }
}
