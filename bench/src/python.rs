//! The peers that are packages of Python, in a virtual environment of their own.

use std::path::PathBuf;
use std::process::Command;

use serde::de::DeserializeOwned;

use crate::command::output;
use crate::contestant::Contestant;
use crate::folders::Folders;

/// A virtual environment.
pub(crate) struct Python {
    program: PathBuf,
    scripts: PathBuf,
}

impl Python {
    pub(crate) fn new(folders: &Folders) -> Result<Self, String> {
        let environment = folders.output.join("python");
        let program = environment.join("bin").join("python");
        if !program.exists() {
            output(
                Command::new("python3")
                    .args(["-m", "venv"])
                    .arg(&environment),
            )?;
        }
        let scripts = folders.peers.clone();
        Ok(Self { program, scripts })
    }

    /// Does nothing if the versions are there.
    pub(crate) fn install(&self, requirements: &[&str]) -> Result<(), String> {
        let mut command = Command::new(&self.program);
        command.args([
            "-m",
            "pip",
            "install",
            "--quiet",
            "--disable-pip-version-check",
        ]);
        output(command.args(requirements)).map(drop)
    }

    /// A script of the peers that answers questions.
    pub(crate) fn start(&self, script: &str, arguments: &[&str]) -> Result<Contestant, String> {
        let mut command = Command::new(&self.program);
        command
            .arg(self.scripts.join(script))
            .args(arguments)
            .env("PYTHONDONTWRITEBYTECODE", "1");
        Contestant::start(&mut command)
    }

    /// Runs a script of the peers, and reads what it prints.
    pub(crate) fn run<T: DeserializeOwned>(
        &self,
        script: &str,
        arguments: &[&str],
    ) -> Result<T, String> {
        let text = output(
            Command::new(&self.program)
                .arg(self.scripts.join(script))
                .args(arguments)
                .env("PYTHONDONTWRITEBYTECODE", "1"),
        )?;
        serde_json::from_str(&text).map_err(|error| format!("{script}: {error}"))
    }
}
