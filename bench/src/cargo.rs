//! Our side: writes the crate of a model, builds it as a user would, and runs it.

use std::collections::HashMap;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::time::Instant;
use std::{env, fs};

use lagrangian_bench::{Report, Request};

use crate::command::output;
use crate::declaration::source;
use crate::flags::Flags;
use crate::folders::{Folders, create, write};
use crate::model::Model;

/// A crate that has been built.
pub(crate) struct Built {
    program: PathBuf,
    /// What the build took, with the dependencies there already.
    pub(crate) seconds: f64,
}

/// Builds the dependencies of all models, so that no model is charged with them. Then says what the
/// build of a crate takes that has them and nothing else.
pub(crate) fn build_dependencies(folders: &Folders) -> Result<f64, String> {
    let empty = || package(folders, "empty", "fn main() {}\n");
    for flags in Flags::ALL {
        cargo_build(folders, &empty()?, flags)?;
    }
    let package = empty()?;
    let start = Instant::now();
    cargo_build(folders, &package, Flags::Native)?;
    Ok(start.elapsed().as_secs_f64())
}

pub(crate) fn build(folders: &Folders, model: Model, flags: Flags) -> Result<Built, String> {
    let name = format!("model-{model}");
    // Written anew, it is built anew.
    let package = package(folders, &name, &source(model))?;
    let start = Instant::now();
    cargo_build(folders, &package, flags)?;
    let seconds = start.elapsed().as_secs_f64();
    let name = format!("{name}{}", env::consts::EXE_SUFFIX);
    let program = target(folders, flags).join("release").join(name);
    Ok(Built { program, seconds })
}

impl Built {
    /// Has all that the request names measured.
    pub(crate) fn run(&self, folders: &Folders, request: &Request) -> Result<Report, String> {
        let path = folders.output.join("request.json");
        let text = serde_json::to_string(request).map_err(|error| error.to_string())?;
        write(&path, &text)?;
        let report = output(Command::new(&self.program).arg(&path))?;
        serde_json::from_str(&report).map_err(|error| format!("{report}: {error}"))
    }
}

/// The milliseconds of a derivation, by model, as the derive's own timing prints them.
pub(crate) fn derive_times(folders: &Folders) -> Result<HashMap<String, f64>, String> {
    let text = output(
        cargo(&folders.workspace)
            .args([
                "test",
                "-p",
                "lagrangian-derive",
                "timing",
                "--",
                "--nocapture",
            ])
            .args(["--quiet", "--test-threads=1"])
            .env("CARGO_TARGET_DIR", &folders.target),
    )?;
    let time = |line: &str| {
        let (name, rest) = line.split_once(": ")?;
        let (milliseconds, _) = rest.split_once(" ms")?;
        Some((name.to_owned(), milliseconds.parse().ok()?))
    };
    Ok(text.lines().filter_map(time).collect())
}

/// Writes a package that stands alone and depends on this checkout, with the versions of its lock.
fn package(folders: &Folders, name: &str, main: &str) -> Result<PathBuf, String> {
    let package = folders.output.join("models").join(name);
    create(&package.join("src"))?;
    let path = |part| folders.workspace.join(part).to_string_lossy().into_owned();
    let (runtime, bench) = (path("runtime"), path("bench"));
    let manifest = format!(
        "[package]\nname = {name:?}\nedition = \"2024\"\n\n[workspace]\n\n[dependencies]\n\
         lagrangian = {{ path = {runtime:?} }}\nlagrangian-bench = {{ path = {bench:?} }}\n"
    );
    write(&package.join("Cargo.toml"), &manifest)?;
    write(&package.join("src/main.rs"), main)?;
    fs::copy(
        folders.workspace.join("Cargo.lock"),
        package.join("Cargo.lock"),
    )
    .map_err(|error| format!("Cargo.lock: {error}"))?;
    Ok(package)
}

fn cargo_build(folders: &Folders, package: &Path, flags: Flags) -> Result<(), String> {
    let mut command = cargo(package);
    command
        .args(["build", "--release"])
        // Set even if empty: what the caller has set must not come through.
        .env("RUSTFLAGS", flags.rust())
        .env_remove("CARGO_ENCODED_RUSTFLAGS")
        .env("CARGO_TARGET_DIR", target(folders, flags));
    output(&mut command).map(drop)
}

fn cargo(folder: &Path) -> Command {
    let mut command = Command::new(env::var_os("CARGO").unwrap_or_else(|| "cargo".into()));
    command.current_dir(folder);
    command
}

fn target(folders: &Folders, flags: Flags) -> PathBuf {
    folders.output.join(flags.name())
}
