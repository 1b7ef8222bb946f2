//! Our Taylor series method beside heyoka's: trajectories to t = 1000 at tolerance 2⁻⁵², the default of both.
//!
//! heyoka integrates equations by hand with constants folded (`peers/systems.py`), by several of its settings, and
//! for the tops and the double pendulum also those that its own `lagrangian()` derives. We integrate the declared
//! model, its parameters read at run time. Every run is a whole integration: ours prepares the model and starts the
//! method, heyoka's has its code compiled already. Final states are compared with references in quadruple precision
//! (`peers/trajectories.json`), which our method in double-double has to confirm first; energies are computed in
//! double-double from the final states.

mod angle;
mod lanes;
mod table;

use lagrangian_bench::{Integration, Question};

use crate::arguments::Arguments;
use crate::cargo::build;
use crate::contest::{self, Entry, Rounds};
use crate::contestant::Contestant;
use crate::declaration::Calls;
use crate::flags::Flags;
use crate::folders::Folders;
use crate::model::Model;
use crate::peers::{heyoka, skipped};
use crate::python::Python;
use crate::trajectories::{END, Trajectory, error};
use crate::verdict::{Verdict, judge};

/// Our default method, and the others that have a name.
const DEFAULT: &str = "Taylor";
const METHODS: [&str; 3] = [DEFAULT, "Taylor 16", "Taylor 12"];

/// For what takes seconds, the lowest order, which is the slowest at this tolerance, is left out.
fn methods(model: Model) -> &'static [&'static str] {
    match model {
        Model::Pendulum(10..) | Model::Arm => &METHODS[..2],
        _ => &METHODS,
    }
}

/// By how much our double-doubles and the quadruple precision may differ. The equations by hand fold constants, such as
/// 1.3 · 9.81 · 0.4, in doubles, so that they are those of parameters that differ by 1e-16; twenty links enlarge
/// that by their condition, 5e5.
const CONFIRMED: f64 = 1e-9;

/// The sides of a contest.
const NATIVE: usize = 0;
const DEFAULT_FLAGS: usize = 1;
const HEYOKA: usize = 2;

/// What is found of a system.
struct Sheet {
    model: Model,
    contestants: Vec<Contestant>,
    trajectory: Trajectory,
    rounds: Rounds,
}

/// Measures all systems, prints the tables, and is an error where a limit is missed.
pub(crate) fn run(arguments: &Arguments) -> Result<(), String> {
    let folders = Folders::new()?;
    let python = heyoka(&folders);
    if let Err(error) = &python {
        skipped("heyoka", error);
    }
    let mut verdicts = Vec::new();
    for &model in &arguments.models {
        let mut sheet = Sheet::new(&folders, python.as_ref().ok(), model, arguments.quick)?;
        sheet.confirm_references(&folders, arguments.confirm)?;
        sheet.single(&mut verdicts)?;
        if has_lagrangian(model) {
            lanes::compare(&mut sheet, &mut verdicts)?;
        }
        if model == Model::SymmetricTop {
            angle::compare(&mut sheet, &folders, &mut verdicts)?;
        }
    }
    judge(&verdicts)
}

/// Whether heyoka's `lagrangian()` takes part: for the others its equations cost several times those by hand.
fn has_lagrangian(model: Model) -> bool {
    matches!(
        model,
        Model::SymmetricTop | Model::GeneralTop | Model::Pendulum(2)
    )
}

/// heyoka's settings. Its compact mode is for systems that take long to compile, and fast math earns nothing there.
fn heyoka_methods(model: Model) -> &'static [&'static str] {
    match model {
        Model::Pendulum(3..) => &["hand", "hand, compact"],
        _ if has_lagrangian(model) => &[
            "hand",
            "hand, fast math",
            "lagrangian",
            "lagrangian, fast math",
        ],
        _ => &["hand", "hand, fast math"],
    }
}

impl Sheet {
    fn new(
        folders: &Folders,
        python: Option<&Python>,
        model: Model,
        quick: bool,
    ) -> Result<Self, String> {
        eprintln!("{model}: deriving, compiling, measuring");
        let mut contestants = Vec::new();
        let calls = if has_lagrangian(model) {
            Calls::Integrate
        } else {
            Calls::IntegrateAlone
        };
        for flags in Flags::ALL {
            contestants.push(build(folders, model, calls, flags)?.start()?);
        }
        if let Some(python) = python {
            contestants.push(python.start("heyoka_taylor.py", &[&model.to_string()])?);
        }
        Ok(Self {
            model,
            contestants,
            trajectory: Trajectory::of(folders, model)?,
            rounds: Rounds::new(quick),
        })
    }

    /// Our method in double-double ends where heyoka's in quadruple precision does. Where asked for, it integrates again.
    fn confirm_references(&self, folders: &Folders, again: bool) -> Result<(), String> {
        let Trajectory {
            end, declared_end, ..
        } = &self.trajectory;
        let mut difference = error(declared_end, end);
        println!(
            "\n{}: the references differ by {difference:.0e}",
            self.model
        );
        if again {
            let starts = self.trajectory.starts(1);
            let truths = truths(folders, self.model, &starts)?;
            let changed = error(&truths[0], declared_end);
            println!("  in double-double again, by {changed:.0e}");
            difference = difference.max(changed);
        }
        if difference <= CONFIRMED {
            Ok(())
        } else {
            Err(format!(
                "the references of {} are not confirmed",
                self.model
            ))
        }
    }

    /// One trajectory at a time.
    fn single(&mut self, verdicts: &mut Vec<Verdict>) -> Result<(), String> {
        let starts = [self.trajectory.start.clone()];
        let entries = self.contest(methods(self.model), heyoka_methods(self.model), &starts)?;
        let lines = self.lines(&entries)?;
        print!("{}", table::table(&lines));
        self.judge_times(&entries, verdicts);
        verdicts.extend(self.judge_errors(&lines));
        Ok(())
    }

    fn judge_times(&self, entries: &[Entry], verdicts: &mut Vec<Verdict>) {
        let ours = fewest(entries, NATIVE, |method| method == DEFAULT);
        for (equations, target, limit) in [("hand", 0.7, 1.0), ("lagrangian", 0.3, 0.4)] {
            let theirs = fewest(entries, HEYOKA, |method| method.starts_with(equations));
            if theirs.is_finite() {
                verdicts.push(Verdict {
                    what: format!("{}, time over heyoka's, {equations}", self.model),
                    figure: ours / theirs,
                    target,
                    limit,
                });
            }
        }
    }

    /// Errors and drifts of one motion at rounding level are chance up to some factor, hence the limit.
    fn judge_errors(&self, lines: &[table::Line]) -> Vec<Verdict> {
        let line = |name: &str| lines.iter().find(|line| line.name == name);
        let (Some(ours), Some(theirs)) = (line("lagrangian, Taylor"), line("heyoka, hand")) else {
            return Vec::new();
        };
        let verdict = |what: &str, ours: f64, theirs: f64| Verdict {
            what: format!("{}, {what} over heyoka's, hand", self.model),
            figure: ours / theirs,
            target: 1.0,
            limit: 10.0,
        };
        let mut verdicts = vec![verdict("error", ours.error, theirs.error)];
        if let (Some(ours), Some(theirs)) = (ours.drift, theirs.drift) {
            verdicts.push(verdict("energy drift", ours, theirs));
        }
        verdicts
    }

    /// Measures methods of ours, with both flags, and of heyoka's.
    fn contest(
        &mut self,
        ours: &[&str],
        theirs: &[&str],
        starts: &[Vec<f64>],
    ) -> Result<Vec<Entry>, String> {
        let sides = [(NATIVE, ours), (DEFAULT_FLAGS, ours), (HEYOKA, theirs)];
        let there = sides
            .iter()
            .filter(|(side, _)| *side < self.contestants.len());
        let mut entries: Vec<Entry> = there
            .flat_map(|&(side, methods)| {
                methods
                    .iter()
                    .map(move |method| Entry::new(side, method, starts, END))
            })
            .collect();
        contest::run(&mut self.contestants, &mut entries, self.rounds);
        match entries
            .iter()
            .find(|entry| entry.side != HEYOKA && entry.result.is_none())
        {
            Some(entry) => Err(format!(
                "{} on {} failed",
                entry.integration.method, self.model
            )),
            None => Ok(entries),
        }
    }

    /// The lines of a table: ours with both flags in one. Errors are those of the first motion, against the solution
    /// of each side's own equations, which differ by how constants are rounded.
    fn lines(&mut self, entries: &[Entry]) -> Result<Vec<table::Line>, String> {
        let mut lines = Vec::new();
        for entry in entries.iter().filter(|entry| entry.side != DEFAULT_FLAGS) {
            let Some(result) = &entry.result else {
                continue;
            };
            let method = &entry.integration.method;
            let with_default_flags = fewest(entries, DEFAULT_FLAGS, |other| other == method);
            let (who, truth) = if entry.side == NATIVE {
                ("lagrangian", &self.trajectory.declared_end)
            } else {
                ("heyoka", &self.trajectory.end)
            };
            let first = result.states.first();
            let error = first.map_or(f64::NAN, |state| error(state, truth));
            lines.push(table::Line {
                name: format!("{who}, {method}"),
                seconds: result.seconds,
                with_default_flags,
                motions: result.states.len(),
                steps: result.steps,
                error,
                drift: self.drift(&entry.integration.starts, &result.states)?,
            });
        }
        Ok(lines)
    }

    /// By how much the energy has changed, relative to it; the arm does not keep it.
    fn drift(&mut self, starts: &[Vec<f64>], ends: &[Vec<f64>]) -> Result<Option<f64>, String> {
        if self.model == Model::Arm {
            return Ok(None);
        }
        let mut largest: f64 = 0.0;
        for (start, end) in starts.iter().zip(ends) {
            let question = Question::EnergyDrifts(vec![start.clone(), end.clone()]);
            let drifts: Vec<f64> = self.contestants[NATIVE].ask(&question)?;
            largest = drifts
                .iter()
                .fold(largest, |largest, drift| largest.max(drift.abs()));
        }
        Ok(Some(largest))
    }
}

/// Final states in double-double.
fn truths(folders: &Folders, model: Model, starts: &[Vec<f64>]) -> Result<Vec<Vec<f64>>, String> {
    let built = build(folders, model, Calls::IntegratePrecisely, Flags::Native)?;
    let mut contestant = built.start()?;
    let mut truth = |start: &Vec<f64>| {
        let integrated = contestant.integrate(&Integration {
            method: "Taylor 40".to_owned(),
            tolerance: None,
            starts: vec![start.clone()],
            end: END,
            at_least: 0.0,
        })?;
        let end = integrated.states.into_iter().next();
        end.ok_or_else(|| "no state".to_owned())
    };
    starts.iter().map(&mut truth).collect()
}

/// The fewest seconds of a side's methods; not a number where it has none.
fn fewest(entries: &[Entry], side: usize, method: impl Fn(&str) -> bool) -> f64 {
    let wanted = entries
        .iter()
        .filter(|entry| entry.side == side && method(&entry.integration.method));
    wanted.map(Entry::seconds).fold(f64::NAN, f64::min)
}
