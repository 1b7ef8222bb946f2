//! Ensembles: 10,000 motions of a model over ten seconds on one core, integrated by us, by heyoka and by `ode_solvers`, at
//! equal measured errors.
//!
//! The members start at states that change little from one to the next ([`starts`]), so that those which heyoka integrates in
//! one batch take nearly the same steps, and none waits for the others. The error of a member is the largest difference of a
//! component of its final state from the reference, relative to the reference where this exceeds 1; the error of an
//! ensemble is the 90th percentile over its members. Angles of the pendulum are so small that the largest error, which is
//! printed beside the percentile, is within ten times it: no motion is dominated by chaos. The reference is ours at the default tolerance, 2⁻⁵², after heyoka's at the same tolerance has
//! confirmed it. Each method then gets the greatest tolerance, relative and absolute alike, in eighths of a decade, at which the
//! measured error is at most 1e-9 ([`tolerance`]).
//!
//! Ours is what a user writes: an [`Ensemble`](lagrangian::Ensemble) of problems of the declared model, its parameters read at run
//! time, in 4 and in 8 lanes, by each of the named orders; a run creates the problems, integrates them and keeps the final states.
//! Of heyoka's, whose equations are by hand with constants folded and whose code is compiled before, the calls of
//! `propagate_until` are timed, and not the loop in Python around them (`peers/heyoka_ensemble.py`); such a call costs some 4 µs besides its
//! steps, some 2 % of the time of a batch. Its batches have the size that it recommends, or 8 members, and its own ensembles copy the
//! integrator for every member. `ode_solvers` integrates the same equations by hand by its DOP853 in a parallel iterator of rayon with one
//! thread (`peers/solvers.rs`). All are compiled for this processor, run in turn, and the fastest run of each counts, in CPU time. The best
//! of our methods is compared with the best of heyoka's.
//!
//! Then our best one is measured against itself: with a declared event that occurs again and again and is recorded, and with one that
//! never occurs. Finally, the clock tells how many motions a study on two threads completes in a second, in turn with two
//! processes of one core each that integrate the same members at the same time ([`threads`]).

mod errors;
mod starts;
mod table;
mod threads;
mod tolerance;

use std::path::Path;
use std::process::Command;

use crate::arguments::Arguments;
use crate::cargo::{Built, build, build_peer};
use crate::contest::{self, Entry, Rounds};
use crate::contestant::Contestant;
use crate::declaration::Calls;
use crate::flags::Flags;
use crate::folders::Folders;
use crate::model::Model;
use crate::peers::{heyoka, skipped};
use crate::python::Python;
use crate::verdict::{Verdict, judge};

use errors::Reference;
use table::{Line, table};
use tolerance::tolerance_for;

/// The time of all ends.
const END: f64 = 10.0;

/// The error at which times are compared.
const COMPARED: f64 = 1e-9;

/// How much the references of both sides may differ, in the norm in which errors are measured.
const CONFIRMED: f64 = 1e-11;

/// Our methods, and in how many lanes each of them runs.
const OURS: [&str; 4] = ["Taylor 12", "Taylor 16", "Taylor 20", "Taylor"];
const LANES: [&str; 2] = ["4 lanes", "8 lanes"];

/// heyoka's method by which its tolerance is sought, and all that run at it.
const BATCHES: &str = "batches of recommended";
const HEYOKA: [&str; 8] = [
    BATCHES,
    "batches of recommended, fast math",
    "batches of 8",
    "batches of 8, fast math",
    "batches of 8, vectors of 512 bits",
    "alone",
    "ensemble",
    "ensemble of batches of recommended",
];

const ODE_SOLVERS: &str = "ode_solvers";

/// Whose a contestant is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Side {
    Ours,
    Heyoka,
    Solvers,
}

impl Side {
    const fn name(self) -> &'static str {
        match self {
            Self::Ours => "lagrangian",
            Self::Heyoka => "heyoka",
            Self::Solvers => "ode_solvers",
        }
    }
}

/// A method at its tolerance.
#[derive(Clone, Debug)]
struct Tuned {
    side: usize,
    method: String,
    tolerance: f64,
}

/// An ensemble of a model, and those who integrate it.
struct Sheet {
    model: Model,
    /// Our program.
    built: Built,
    contestants: Vec<Contestant>,
    sides: Vec<Side>,
    starts: Vec<Vec<f64>>,
    reference: Reference,
    rounds: Rounds,
}

/// Measures, prints, and is an error where a limit is missed.
pub(crate) fn run(arguments: &Arguments) -> Result<(), String> {
    let folders = Folders::new()?;
    let python = heyoka(&folders)
        .map_err(|error| skipped("heyoka", &error))
        .ok();
    let solvers = build_peer(&folders, "solvers", &[])
        .map_err(|error| skipped("ode_solvers", &error))
        .ok();
    let mut verdicts = Vec::new();
    for &model in &arguments.models {
        eprintln!("{model}: deriving, compiling, measuring");
        let peers = (python.as_ref(), solvers.as_deref());
        let mut sheet = Sheet::new(&folders, peers, model, arguments.quick)?;
        sheet.confirm_reference()?;
        let best = sheet.beside_peers(&mut verdicts)?;
        sheet.events(&best, &mut verdicts)?;
        sheet.by_the_clock(&best, &mut verdicts)?;
    }
    judge(&verdicts)
}

impl Sheet {
    fn new(
        folders: &Folders,
        (python, solvers): (Option<&Python>, Option<&Path>),
        model: Model,
        quick: bool,
    ) -> Result<Self, String> {
        let name = model.to_string();
        let starts = starts::of(model)?;
        let built = build(folders, model, Calls::Ensembles, Flags::Native)?;
        let mut ours = built.start()?;
        let reference = Entry::new(0, "Taylor, 4 lanes", &starts, END);
        let reference = ours.integrate(&reference.integration)?.states;
        let (mut contestants, mut sides) = (vec![ours], vec![Side::Ours]);
        if let Some(python) = python {
            contestants.push(python.start("heyoka_ensemble.py", &[&name])?);
            sides.push(Side::Heyoka);
        }
        if let Some(solvers) = solvers {
            contestants.push(Contestant::start(Command::new(solvers).arg(&name))?);
            sides.push(Side::Solvers);
        }
        Ok(Self {
            model,
            built,
            contestants,
            sides,
            starts,
            reference: Reference(reference),
            rounds: Rounds::new(quick),
        })
    }

    /// heyoka's motions end where ours do.
    fn confirm_reference(&mut self) -> Result<(), String> {
        let Some(side) = self.sides.iter().position(|side| *side == Side::Heyoka) else {
            return Ok(());
        };
        let entry = Entry::new(side, BATCHES, &self.starts, END);
        let states = self.contestants[side].integrate(&entry.integration)?.states;
        let difference = self.reference.errors(&states);
        println!(
            "\n{}: the references differ by {:.0e}, at most by {:.0e}",
            self.model, difference.percentile, difference.largest
        );
        if difference.percentile <= CONFIRMED {
            Ok(())
        } else {
            Err(format!("the reference of {} is not confirmed", self.model))
        }
    }

    /// All methods of all sides at the tolerances at which they have the error that is compared.
    fn tuned(&mut self) -> Result<Vec<Tuned>, String> {
        let mut tuned = Vec::new();
        for (side, whose) in self.sides.clone().into_iter().enumerate() {
            let families = match whose {
                Side::Ours => {
                    let in_lanes = |order| LANES.map(|lanes| format!("{order}, {lanes}")).to_vec();
                    OURS.map(in_lanes).to_vec()
                }
                Side::Heyoka => vec![HEYOKA.map(str::to_owned).to_vec()],
                Side::Solvers => vec![vec![ODE_SOLVERS.to_owned()]],
            };
            for family in families {
                let tolerance = self.tolerance(side, &family[0])?;
                tuned.extend(family.into_iter().map(|method| Tuned {
                    side,
                    method,
                    tolerance,
                }));
            }
        }
        Ok(tuned)
    }

    fn tolerance(&mut self, side: usize, method: &str) -> Result<f64, String> {
        tolerance_for(COMPARED, |tolerance| {
            let mut entry = Entry::new(side, method, &self.starts, END).with_tolerance(tolerance);
            entry.integration.at_least = 0.0;
            let found = self.contestants[side].integrate(&entry.integration)?;
            Ok(self.reference.errors(&found.states).percentile)
        })
    }

    /// Runs methods in turn.
    fn contest(&mut self, methods: &[Tuned]) -> Vec<Entry> {
        let entry = |tuned: &Tuned| {
            Entry::new(tuned.side, &tuned.method, &self.starts, END).with_tolerance(tuned.tolerance)
        };
        let mut entries: Vec<Entry> = methods.iter().map(entry).collect();
        contest::run(&mut self.contestants, &mut entries, self.rounds);
        entries
    }

    /// Compares all methods at equal errors, and returns our best one.
    fn beside_peers(&mut self, verdicts: &mut Vec<Verdict>) -> Result<Tuned, String> {
        let tuned = self.tuned()?;
        let entries = self.contest(&tuned);
        print!("{}", table(&self.lines(&entries)));
        let best = |whose: Side| {
            let pairs = tuned.iter().zip(&entries);
            let there = pairs.filter(|(tuned, entry)| {
                self.sides[tuned.side] == whose && entry.seconds().is_finite()
            });
            there.min_by(|(_, one), (_, other)| one.seconds().total_cmp(&other.seconds()))
        };
        let (ours, entry) =
            best(Side::Ours).ok_or_else(|| format!("no ensemble of {}", self.model))?;
        for (peer, what) in [(Side::Heyoka, "heyoka's"), (Side::Solvers, "ode_solvers'")] {
            if let Some((_, theirs)) = best(peer) {
                verdicts.push(Verdict {
                    what: format!("{}, ensemble, time over {what}", self.model),
                    figure: entry.seconds() / theirs.seconds(),
                    target: 0.6,
                    limit: 0.8,
                });
            }
        }
        Ok(ours.clone())
    }

    /// Our best method with events and without.
    fn events(&mut self, best: &Tuned, verdicts: &mut Vec<Verdict>) -> Result<(), String> {
        let with = |event: &str| Tuned {
            method: format!("{}, {event}", best.method),
            ..best.clone()
        };
        let cases = [best.clone(), with("recorded event"), with("absent event")];
        let entries = self.contest(&cases);
        print!("{}", table(&self.lines(&entries)));
        for (entry, limit) in entries.iter().skip(1).zip([1.2, 1.1]) {
            let method = &entry.integration.method;
            let result = entry
                .result
                .as_ref()
                .ok_or_else(|| format!("{method} failed"))?;
            #[allow(clippy::cast_precision_loss)] // Counts.
            let often = result.events as f64 / result.steps as f64;
            verdicts.push(Verdict {
                what: format!("{}, {method}, {often:.2} a step, over none", self.model),
                figure: entry.seconds() / entries[0].seconds(),
                target: limit,
                limit,
            });
        }
        Ok(())
    }

    fn lines(&self, entries: &[Entry]) -> Vec<Line> {
        let line = |entry: &Entry| {
            let result = entry.result.as_ref()?;
            let whose = self.sides[entry.side].name();
            Some(Line {
                name: format!("{whose}, {}", entry.integration.method),
                tolerance: entry.integration.tolerance.unwrap_or(f64::NAN),
                errors: self.reference.errors(&result.states),
                steps: result.steps,
                seconds: result.seconds,
                motions: result.states.len(),
            })
        };
        entries.iter().filter_map(line).collect()
    }
}
