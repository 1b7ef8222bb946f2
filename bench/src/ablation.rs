//! Each model with all passes of the derivation, and with each of them switched off.
//!
//! A pass that nothing is worse without does not earn its place. Every variant of a model is a program of
//! its own, built with the derive's feature `ablation`; its accelerations have to agree with those of all
//! passes, at the states at which peers are compared. The programs run in turn, time after time, and
//! the fastest round of each counts. One that is the same to the last byte as that of all passes is not
//! measured: the pass has no part in it.

use lagrangian_bench::{Answers, Operations, Request};

use crate::arguments::Arguments;
use crate::cargo::{Built, build_without};
use crate::folders::Folders;
use crate::model::Model;
use crate::passes::Off;
use crate::states::states;

/// How many times all programs of a model run, and how many rounds each has then.
const TURNS: usize = 20;
const ROUNDS: usize = 15;

/// What is found of one model.
pub(crate) struct Ablation {
    pub(crate) model: Model,
    /// In the order of [`Off::all`]; none where the program is that of all passes.
    pub(crate) figures: Vec<Option<Figures>>,
}

/// What is found of one variant.
#[derive(Clone, Copy)]
pub(crate) struct Figures {
    pub(crate) operations: Operations,
    /// Nanoseconds for each of independent evaluations.
    pub(crate) nanoseconds: f64,
    pub(crate) rounding: f64,
}

/// Builds and measures all variants of all models.
pub(crate) fn run(arguments: &Arguments) -> Result<Vec<Ablation>, String> {
    let folders = Folders::new()?;
    let turns = if arguments.quick { 1 } else { TURNS };
    let models = arguments.models.iter();
    let ablations = models.map(|model| {
        let programs = programs(&folders, *model)?;
        measured(&folders, *model, &programs, turns)
    });
    ablations.collect()
}

/// The programs of one model that differ from the first.
fn programs(folders: &Folders, model: Model) -> Result<Vec<Option<Built>>, String> {
    let mut programs: Vec<Option<Built>> = Vec::new();
    for off in Off::all() {
        let built = build_without(folders, model, off)?;
        let (label, seconds) = (off.label(), built.seconds);
        eprintln!("{model} without {label}: built in {seconds:.1} s");
        let same = match programs.first() {
            Some(Some(complete)) => built.equals(complete)?,
            _ => false,
        };
        programs.push(if same { None } else { Some(built) });
    }
    Ok(programs)
}

/// Runs the programs in turn.
fn measured(
    folders: &Folders,
    model: Model,
    programs: &[Option<Built>],
    turns: usize,
) -> Result<Ablation, String> {
    let mut request = Request {
        model: model.to_string(),
        states: states(model),
        libraries: Vec::new(),
        answers: Vec::new(),
        rounds: ROUNDS,
    };
    let mut figures: Vec<Option<Figures>> = vec![None; programs.len()];
    for _ in 0..turns {
        for (figures, program) in figures.iter_mut().zip(programs) {
            let Some(program) = program else { continue };
            let report = program.run(folders, &request)?;
            if request.answers.is_empty() {
                // The first is that of all passes, with which the others have to agree.
                request.answers.push(Answers {
                    name: "all passes".to_owned(),
                    accelerations: report.accelerations,
                });
            }
            let time = report.measurements[0].throughput.unwrap_or(f64::NAN);
            let best = figures.map_or(time, |figures| figures.nanoseconds.min(time));
            *figures = Some(Figures {
                operations: report.operations,
                nanoseconds: best,
                rounding: report.rounding.unwrap_or(f64::NAN),
            });
        }
    }
    Ok(Ablation { model, figures })
}
