//! What `CasADi` generates for the arm: from the recursions, and from a declared Lagrangian.

use std::path::PathBuf;

use serde::Deserialize;

use super::arm::description;
use crate::folders::{Folders, write};
use crate::peers::CASADI;
use crate::python::Python;

/// From a declared Lagrangian it takes minutes for more links.
const DECLARED_LINKS: usize = 6;

/// What the script says that has written C.
#[derive(Deserialize)]
struct Written {
    operations: usize,
}

/// C that has been generated.
pub(super) struct Source {
    pub(super) name: String,
    pub(super) path: PathBuf,
    pub(super) operations: usize,
}

/// Python with `CasADi`.
pub(super) struct Casadi(Python);

impl Casadi {
    pub(super) fn new(folders: &Folders) -> Result<Self, String> {
        let python = Python::new(folders)?;
        python.install(&[CASADI])?;
        Ok(Self(python))
    }

    /// The C of an algorithm, by its name in the script; none for a declared Lagrangian of many links.
    pub(super) fn source(
        &self,
        folders: &Folders,
        algorithm: &str,
        links: usize,
    ) -> Result<Option<Source>, String> {
        if algorithm.starts_with("lagrangian") && links > DECLARED_LINKS {
            return Ok(None);
        }
        let arm = folders.output.join("arm.json");
        write(&arm, &description(links).to_string())?;
        let path = folders.output.join(format!("casadi_{algorithm}_{links}.c"));
        let arguments = [algorithm, &arm.to_string_lossy(), &path.to_string_lossy()];
        let Written { operations } = self.0.run("casadi_arm.py", &arguments)?;
        Ok(Some(Source {
            name: format!("CasADi, {}", algorithm.replace('_', " ")),
            path,
            operations,
        }))
    }
}
