//! One model and all its peers.

use std::collections::HashMap;

use lagrangian_bench::{Answers, Library, Measurement, Operations, Report, Request};

use crate::arguments::Arguments;
use crate::cargo::{build, build_dependencies, derive_times};
use crate::compiler::compile;
use crate::declaration::Calls;
use crate::flags::Flags;
use crate::folders::Folders;
use crate::model::Model;
use crate::peers::{Heyoka, Peers, skipped};
use crate::side::{CSource, Side, Times};
use crate::states::states;

const HEYOKA: &str = "heyoka, 8 lanes";

/// What is found of a model.
pub(crate) struct Comparison {
    pub(crate) model: Model,
    /// Ours first.
    pub(crate) sides: Vec<Side>,
    /// Ours, by kind.
    pub(crate) operations: Operations,
}

/// What is prepared once for all models.
pub(crate) struct Workshop {
    folders: Folders,
    peers: Peers,
    derive_times: HashMap<String, f64>,
    /// What the build of a crate without a model takes.
    pub(crate) empty_seconds: f64,
    rounds: usize,
}

impl Workshop {
    pub(crate) fn new(arguments: &Arguments) -> Result<Self, String> {
        let folders = Folders::new()?;
        eprintln!("installing the peers below {}", folders.output.display());
        let peers = Peers::new(arguments, &folders);
        eprintln!("building what the models depend on");
        let empty_seconds = build_dependencies(&folders)?;
        let derive_times = derive_times(&folders).unwrap_or_else(|error| {
            skipped("the time of our derivations", &error);
            HashMap::new()
        });
        let rounds = arguments.rounds();
        Ok(Self {
            folders,
            peers,
            derive_times,
            empty_seconds,
            rounds,
        })
    }

    /// Builds a model and its peers, checks that they agree, and measures them.
    pub(crate) fn compare(&self, model: Model) -> Result<Comparison, String> {
        eprintln!("{model}: deriving, compiling, measuring");
        let states = states(model);
        let mut sources = self.peers.sources(&self.folders, model.system());
        let heyoka = self
            .peers
            .heyoka(&self.folders, model.system(), &states, self.rounds);
        let mut request = Request {
            model: model.to_string(),
            states,
            libraries: Vec::new(),
            answers: heyoka.iter().map(answers).collect(),
            rounds: self.rounds,
        };
        let mut sides = self.sides(model, &sources, heyoka.as_ref());
        let mut operations = None;
        for flags in Flags::ALL {
            request.libraries = self.libraries(model, &mut sources, &mut sides, flags);
            let built = build(&self.folders, model, Calls::Measure, flags)?;
            if flags == Flags::Native {
                sides[0].compile_seconds = Some(built.seconds);
            }
            let Report {
                operations: ours,
                measurements,
                ..
            } = built.run(&self.folders, &request)?;
            sides[0].operations = Some(ours.total);
            operations = Some(ours);
            for measurement in &measurements {
                record(&mut sides, measurement, flags);
            }
        }
        let operations = operations.ok_or("nothing was measured")?;
        Ok(Comparison {
            model,
            sides,
            operations,
        })
    }

    /// The lines of the table, with what is known before anything is measured.
    fn sides(&self, model: Model, sources: &[CSource], heyoka: Option<&Heyoka>) -> Vec<Side> {
        let ours = Side {
            name: "lagrangian".to_owned(),
            derive_seconds: self
                .derive_times
                .get(&model.to_string())
                .map(|time| time * 1e-3),
            ..Side::default()
        };
        let c = sources.iter().map(|source| Side {
            name: source.name.clone(),
            operations: source.operations,
            derive_seconds: source.derive_seconds,
            ..Side::default()
        });
        let heyoka = heyoka.map(|heyoka| Side {
            name: HEYOKA.to_owned(),
            native: Times {
                throughput: Some(heyoka.throughput),
                latency: None,
            },
            derive_seconds: Some(heyoka.derive_seconds),
            compile_seconds: Some(heyoka.compile_seconds),
            ..Side::default()
        });
        [ours].into_iter().chain(c).chain(heyoka).collect()
    }

    /// Compiles the peers' C; what does not compile is skipped from then on.
    fn libraries(
        &self,
        model: Model,
        sources: &mut Vec<CSource>,
        sides: &mut [Side],
        flags: Flags,
    ) -> Vec<Library> {
        let mut libraries = Vec::new();
        sources.retain(|source| {
            let compiled = match compile(&self.folders, model, source, flags) {
                Ok(compiled) => compiled,
                Err(error) => {
                    skipped(&format!("{} for {model}", source.name), &error);
                    return false;
                }
            };
            if let Some(side) = side(sides, &source.name)
                && flags == Flags::Native
            {
                side.compile_seconds = Some(compiled.seconds);
            }
            let path = compiled.path.to_string_lossy().into_owned();
            libraries.push(Library {
                name: source.name.clone(),
                path,
            });
            true
        });
        libraries
    }
}

fn answers(heyoka: &Heyoka) -> Answers {
    Answers {
        name: HEYOKA.to_owned(),
        accelerations: heyoka.accelerations.clone(),
    }
}

fn record(sides: &mut [Side], measurement: &Measurement, flags: Flags) {
    let Some(side) = side(sides, &measurement.name) else {
        return;
    };
    side.difference = Some(side.difference.unwrap_or(0.0).max(measurement.difference));
    if measurement.throughput.is_some() {
        let times = match flags {
            Flags::Native => &mut side.native,
            Flags::Default => &mut side.default,
            // Models are not compared with these.
            Flags::Vectors256 => return,
        };
        *times = Times {
            throughput: measurement.throughput,
            latency: measurement.latency,
        };
    }
}

fn side<'a>(sides: &'a mut [Side], name: &str) -> Option<&'a mut Side> {
    sides.iter_mut().find(|side| side.name == name)
}
