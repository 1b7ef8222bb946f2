//! The peers: who can be had here, and what each has for a model.

use serde::Deserialize;

use crate::arguments::{Arguments, PeerName};
use crate::compiler;
use crate::folders::{Folders, write};
use crate::model::Model;
use crate::python::Python;
use crate::side::CSource;

/// `SymPy` solves for more links in minutes only.
const SYMPY_LINKS: usize = 5;

/// What pip installs for `CasADi`.
pub(crate) const CASADI: &str = "casadi==3.8.2";

/// What pip installs for heyoka.
const HEYOKA: &[&str] = &["heyoka==7.13.2", "numpy>=2,<3"];

/// Python with heyoka.
pub(crate) fn heyoka(folders: &Folders) -> Result<Python, String> {
    let python = Python::new(folders)?;
    python.install(HEYOKA)?;
    Ok(python)
}

/// Those of the peers that were asked for and that can be had.
pub(crate) struct Peers {
    hand: bool,
    casadi: Option<Python>,
    sympy: Option<Python>,
    heyoka: Option<Python>,
}

/// What heyoka says of itself.
#[derive(Deserialize)]
pub(crate) struct Heyoka {
    pub(crate) derive_seconds: f64,
    pub(crate) compile_seconds: f64,
    pub(crate) throughput: f64,
    pub(crate) accelerations: Vec<Vec<f64>>,
}

/// What a script says that has written C.
#[derive(Deserialize)]
struct Written {
    derive_seconds: f64,
    operations: usize,
}

impl Peers {
    /// Installs what is asked for, and says what is skipped.
    pub(crate) fn new(arguments: &Arguments, folders: &Folders) -> Self {
        let install = |peer, name, requirements: &[&str], compiled: bool| {
            if !arguments.wants(peer) {
                return None;
            }
            let python = || {
                if compiled {
                    compiler::check()?;
                }
                let python = Python::new(folders)?;
                python.install(requirements)?;
                Ok(python)
            };
            python().map_err(|error: String| skipped(name, &error)).ok()
        };
        let hand = || compiler::check().map_err(|error| skipped("C by hand", &error));
        Self {
            hand: arguments.wants(PeerName::Hand) && hand().is_ok(),
            casadi: install(PeerName::Casadi, "CasADi", &[CASADI], true),
            sympy: install(PeerName::Sympy, "SymPy", &["sympy==1.14.0"], true),
            heyoka: install(PeerName::Heyoka, "heyoka", HEYOKA, false),
        }
    }

    /// The C that the peers have for a model.
    pub(crate) fn sources(&self, folders: &Folders, model: Model) -> Vec<CSource> {
        let mut sources = Vec::new();
        if self.hand {
            sources.extend(by_hand(folders, model));
        }
        if let Some(python) = &self.casadi {
            sources.extend(generated(python, folders, "casadi", model));
        }
        if let Some(python) = &self.sympy
            && model.degrees() <= SYMPY_LINKS
        {
            sources.extend(generated(python, folders, "sympy", model));
        }
        sources
    }

    /// heyoka compiles for this processor, and measures itself.
    pub(crate) fn heyoka(
        &self,
        folders: &Folders,
        model: Model,
        states: &[Vec<f64>],
        rounds: usize,
    ) -> Option<Heyoka> {
        let python = self.heyoka.as_ref()?;
        let run = || {
            let path = folders.output.join("states.json");
            let text = serde_json::to_string(states).map_err(|error| error.to_string())?;
            write(&path, &text)?;
            let (model, path) = (model.to_string(), path.to_string_lossy());
            python.run("heyoka_peer.py", &[&model, &path, &rounds.to_string()])
        };
        run()
            .map_err(|error| skipped(&format!("heyoka's {model}"), &error))
            .ok()
    }
}

/// Says that something is left out, and why.
pub(crate) fn skipped(what: &str, why: &str) {
    eprintln!("{what} is skipped: {why}");
}

fn by_hand(folders: &Folders, model: Model) -> Vec<CSource> {
    let files: &[(&str, &str)] = match model {
        Model::SymmetricTop => &[("C, Euler's equations", "symmetric_top.c")],
        Model::GeneralTop | Model::GeneralTopMultipliedOut => {
            &[("C, Euler's equations", "general_top.c")]
        }
        Model::Pendulum(2) | Model::DoublePendulumMultipliedOut => &[
            ("C, closed form", "double_pendulum.c"),
            ("C, dense", "chain_dense.c"),
            ("C, tensions", "chain_tensions.c"),
        ],
        Model::Arm | Model::ThreeBodies => &[],
        Model::Pendulum(_) => &[
            ("C, dense", "chain_dense.c"),
            ("C, tensions", "chain_tensions.c"),
        ],
    };
    let source = |&(name, file): &(&str, &str)| CSource {
        name: name.to_owned(),
        path: folders.peers.join(file),
        operations: None,
        derive_seconds: None,
    };
    files.iter().map(source).collect()
}

fn generated(python: &Python, folders: &Folders, name: &str, model: Model) -> Option<CSource> {
    let path = folders.output.join(format!("{name}_{model}.c"));
    let script = format!("{name}_peer.py");
    let written = python.run::<Written>(&script, &[&model.to_string(), &path.to_string_lossy()]);
    let written = written
        .map_err(|error| skipped(&format!("{name}'s {model}"), &error))
        .ok()?;
    Some(CSource {
        name: name.to_owned(),
        path,
        operations: Some(written.operations),
        derive_seconds: Some(written.derive_seconds),
    })
}
