//! Our side: writes the crate of a model, builds it as a user would, and runs it.

use std::collections::HashMap;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::time::Instant;
use std::{env, fs};

use lagrangian_bench::{Report, Request};

use crate::command::output;
use crate::contestant::Contestant;
use crate::declaration::{Calls, source};
use crate::flags::Flags;
use crate::folders::{Folders, create, write};
use crate::model::Model;
use crate::passes::Off;

/// A crate that has been built.
pub(crate) struct Built {
    program: PathBuf,
    /// What the build took, with the dependencies there already.
    pub(crate) seconds: f64,
}

/// Builds the dependencies of all models, so that no model is charged with them. Then says what the
/// build of a crate takes that has them and nothing else.
pub(crate) fn build_dependencies(folders: &Folders) -> Result<f64, String> {
    build_dependencies_with(folders, &Flags::ALL)
}

/// The same with these flags alone.
pub(crate) fn build_dependencies_with(folders: &Folders, all: &[Flags]) -> Result<f64, String> {
    let empty = || package(folders, "empty", "fn main() {}\n", &[], true);
    for &flags in all {
        cargo_build(folders, &empty()?, flags, None)?;
    }
    let package = empty()?;
    let start = Instant::now();
    cargo_build(folders, &package, Flags::Native, None)?;
    Ok(start.elapsed().as_secs_f64())
}

pub(crate) fn build(
    folders: &Folders,
    model: Model,
    calls: Calls,
    flags: Flags,
) -> Result<Built, String> {
    let name = match calls {
        Calls::Measure | Calls::MeasureWithRounding => format!("model-{model}"),
        Calls::Integrate | Calls::IntegrateAlone => format!("integrated-{model}"),
        Calls::IntegratePrecisely => format!("reference-{model}"),
        Calls::CompareReduced => format!("reduced-{model}"),
        Calls::Taylor => format!("taylor-{model}"),
        Calls::Dop853 => format!("dop853-{model}"),
        Calls::Ensembles => format!("ensembles-{model}"),
    };
    let main = source(model, calls);
    let timed = matches!(
        calls,
        Calls::Measure | Calls::MeasureWithRounding | Calls::Taylor | Calls::Dop853
    );
    let package = match calls {
        Calls::Ensembles => {
            let ensembles = path_in(folders, "ensembles");
            let dependencies = format!(
                "{}lagrangian-ensembles = {{ path = {ensembles:?} }}\n",
                dependencies(folders)
            );
            written(folders, &name, &main, &dependencies, timed)?
        }
        _ => package(folders, &name, &main, &[], timed)?,
    };
    let start = Instant::now();
    cargo_build(folders, &package, flags, None)?;
    let seconds = start.elapsed().as_secs_f64();
    let program = program(folders, &name, flags);
    Ok(Built { program, seconds })
}

/// Builds the crate of a model that is no [`Model`].
pub(crate) fn build_source(
    folders: &Folders,
    name: &str,
    main: &str,
    flags: Flags,
) -> Result<Built, String> {
    let package = package(folders, name, main, &[], true)?;
    let start = Instant::now();
    cargo_build(folders, &package, flags, None)?;
    let seconds = start.elapsed().as_secs_f64();
    let program = program(folders, name, flags);
    Ok(Built { program, seconds })
}

/// Builds a model for this processor with some passes switched off, and keeps the program.
pub(crate) fn build_without(folders: &Folders, model: Model, off: Off) -> Result<Built, String> {
    // One name for all, so that the same code gives the same program.
    let name = format!("ablated-{model}");
    let main = source(model, Calls::MeasureWithRounding);
    let package = package(folders, &name, &main, &["ablation"], true)?;
    let start = Instant::now();
    cargo_build(folders, &package, Flags::Native, Some(&off.passes()))?;
    let seconds = start.elapsed().as_secs_f64();
    let kept = folders.output.join(format!("{name}-{}", off.label()));
    fs::copy(program(folders, &name, Flags::Native), &kept)
        .map_err(|error| format!("{}: {error}", kept.display()))?;
    let program = kept;
    Ok(Built { program, seconds })
}

fn program(folders: &Folders, name: &str, flags: Flags) -> PathBuf {
    let file = format!("{name}{}", env::consts::EXE_SUFFIX);
    target(folders, flags).join("release").join(file)
}

/// The path of a copy of a program or a shared object, by number.
pub(crate) fn copied(path: &Path, number: usize) -> Result<String, String> {
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    let name = name.split_once('~').map_or(&*name, |(_, name)| name);
    let copy = path.with_file_name(format!("{number}~{name}"));
    fs::copy(path, &copy).map_err(|error| format!("{}: {error}", copy.display()))?;
    Ok(copy.to_string_lossy().into_owned())
}

impl Built {
    /// A copy of it, by number.
    pub(crate) fn copied(&self, number: usize) -> Result<Self, String> {
        Ok(Self {
            program: copied(&self.program, number)?.into(),
            seconds: self.seconds,
        })
    }

    /// The program.
    pub(crate) fn program(&self) -> &Path {
        &self.program
    }

    /// Whether both are the same to the last byte.
    pub(crate) fn equals(&self, other: &Self) -> Result<bool, String> {
        let bytes = |built: &Self| {
            let path = &built.program;
            fs::read(path).map_err(|error| format!("{}: {error}", path.display()))
        };
        Ok(bytes(self)? == bytes(other)?)
    }

    /// Runs it as a contestant.
    pub(crate) fn start(&self) -> Result<Contestant, String> {
        Contestant::start(&mut Command::new(&self.program))
    }

    /// Has all that the request names measured.
    pub(crate) fn run(&self, folders: &Folders, request: &Request) -> Result<Report, String> {
        let path = folders.output.join("request.json");
        let text = serde_json::to_string(request).map_err(|error| error.to_string())?;
        write(&path, &text)?;
        let report = output(Command::new(&self.program).arg(&path))?;
        serde_json::from_str(&report).map_err(|error| format!("{report}: {error}"))
    }
}

/// How a crate is built.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Profile {
    Release,
    Debug,
}

impl Profile {
    /// As cargo has it.
    const fn name(self) -> &'static str {
        match self {
            Self::Release => "release",
            Self::Debug => "dev",
        }
    }
}

/// Seconds of a build as users have it, with the dependencies there already.
pub(crate) fn build_seconds(
    folders: &Folders,
    name: &str,
    main: &str,
    profile: Profile,
) -> Result<f64, String> {
    let empty = package(folders, "empty", "fn main() {}\n", &[], true)?;
    build_in_profile(folders, &empty, Flags::Default, profile, None)?;
    let package = package(folders, name, main, &[], true)?;
    let start = Instant::now();
    build_in_profile(folders, &package, Flags::Default, profile, None)?;
    Ok(start.elapsed().as_secs_f64())
}

/// The fewest milliseconds of a derivation, by model, as the derive's own timing prints them.
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
    let mut times = HashMap::new();
    for (name, milliseconds) in text.lines().filter_map(time) {
        let fewest = times.entry(name).or_insert(f64::INFINITY);
        *fewest = fewest.min(milliseconds);
    }
    Ok(times)
}

/// A peer that is written in Rust, for this processor: solvers of other crates. It has these modules.
pub(crate) fn build_peer(
    folders: &Folders,
    name: &str,
    modules: &[&str],
) -> Result<PathBuf, String> {
    let read = |name: &str| {
        let path = folders.peers.join(name).with_extension("rs");
        fs::read_to_string(&path).map_err(|error| format!("{}: {error}", path.display()))
    };
    let main = read(name)?;
    let dependencies = dependencies(folders) + SOLVERS;
    let package = written(folders, name, &main, &dependencies, false)?;
    for module in modules {
        let path = package.join("src").join(module).with_extension("rs");
        write(&path, &read(module)?)?;
    }
    cargo_build(folders, &package, Flags::Native, None)?;
    Ok(program(folders, name, Flags::Native))
}

/// The crates of the solvers, and what their code here needs.
const SOLVERS: &str = "ode_solvers = \"=0.6.2\"\ndifferential-equations = \"=0.7.0\"\n\
                       nalgebra = \"0.34\"\nrayon = \"1.11\"\nserde_json = \"1\"\n";

/// Writes the package of a model. The derive gets these features.
fn package(
    folders: &Folders,
    name: &str,
    main: &str,
    features: &[&str],
    timed: bool,
) -> Result<PathBuf, String> {
    let derive = path_in(folders, "derive");
    let derive = if features.is_empty() {
        String::new()
    } else {
        format!("lagrangian-derive = {{ path = {derive:?}, features = {features:?} }}\n")
    };
    written(
        folders,
        name,
        main,
        &(dependencies(folders) + &derive),
        timed,
    )
}

/// What every package depends on.
fn dependencies(folders: &Folders) -> String {
    let [lagrangian, bench] = ["lagrangian", "bench"].map(|part| path_in(folders, part));
    format!("lagrangian = {{ path = {lagrangian:?} }}\nlagrangian-bench = {{ path = {bench:?} }}\n")
}

/// The path of a package of the workspace.
fn path_in(folders: &Folders, part: &str) -> String {
    folders.workspace.join(part).to_string_lossy().into_owned()
}

/// Writes a package that stands alone and depends on this checkout, with the versions of its lock.
fn written(
    folders: &Folders,
    name: &str,
    main: &str,
    dependencies: &str,
    timed: bool,
) -> Result<PathBuf, String> {
    let package = folders.output.join("models").join(name);
    create(&package.join("src"))?;
    let manifest = format!(
        "[package]\nname = {name:?}\nedition = \"2024\"\n\n[workspace]\n\n[dependencies]\n{dependencies}"
    );
    write(&package.join("Cargo.toml"), &manifest)?;
    let path = package.join("src/main.rs");
    // Written anew, it is built anew, and what the build takes is known.
    if timed || fs::read_to_string(&path).map_or(true, |written| written != main) {
        write(&path, main)?;
    }
    fs::copy(
        folders.workspace.join("Cargo.lock"),
        package.join("Cargo.lock"),
    )
    .map_err(|error| format!("Cargo.lock: {error}"))?;
    Ok(package)
}

fn cargo_build(
    folders: &Folders,
    package: &Path,
    flags: Flags,
    without: Option<&str>,
) -> Result<(), String> {
    build_in_profile(folders, package, flags, Profile::Release, without)
}

fn build_in_profile(
    folders: &Folders,
    package: &Path,
    flags: Flags,
    profile: Profile,
    without: Option<&str>,
) -> Result<(), String> {
    let mut command = cargo(package);
    command
        .args(["build", "--profile", profile.name()])
        // Set even if empty: what the caller has set must not come through.
        .env("RUSTFLAGS", flags.rust())
        .env_remove("CARGO_ENCODED_RUSTFLAGS")
        .env("CARGO_TARGET_DIR", target(folders, flags));
    // Only a derive with the feature `ablation` reads it.
    command.env("LAGRANGIAN_WITHOUT", without.unwrap_or_default());
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
