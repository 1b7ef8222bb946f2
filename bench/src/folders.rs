//! Where things are, and where they are written.

use std::path::{Path, PathBuf};
use std::{env, fs};

/// The folders of the benchmark.
pub(crate) struct Folders {
    /// Of the workspace.
    pub(crate) workspace: PathBuf,
    /// Of the peers' sources.
    pub(crate) peers: PathBuf,
    /// Cargo's target folder.
    pub(crate) target: PathBuf,
    /// Where everything is written: below the target folder.
    pub(crate) output: PathBuf,
}

impl Folders {
    /// The program lies in `release` or `debug` of the target folder.
    pub(crate) fn new() -> Result<Self, String> {
        let package = Path::new(env!("CARGO_MANIFEST_DIR"));
        let program = env::current_exe().map_err(|error| error.to_string())?;
        let target = program
            .ancestors()
            .nth(2)
            .ok_or("there is no target folder")?;
        let output = target.join("bench");
        create(&output)?;
        Ok(Self {
            workspace: package.parent().unwrap_or(package).to_owned(),
            peers: package.join("peers"),
            target: target.to_owned(),
            output,
        })
    }
}

pub(crate) fn create(folder: &Path) -> Result<(), String> {
    fs::create_dir_all(folder).map_err(|error| format!("{}: {error}", folder.display()))
}

pub(crate) fn write(path: &Path, text: &str) -> Result<(), String> {
    fs::write(path, text).map_err(|error| format!("{}: {error}", path.display()))
}
