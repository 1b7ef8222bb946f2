//! Their side: C, compiled into shared objects.

use std::path::PathBuf;
use std::process::Command;
use std::time::Instant;

use crate::command::output;
use crate::flags::Flags;
use crate::folders::Folders;
use crate::model::Model;
use crate::side::CSource;

/// A shared object that has been built.
pub(crate) struct Compiled {
    pub(crate) path: PathBuf,
    pub(crate) seconds: f64,
}

/// Whether there is a compiler.
pub(crate) fn check() -> Result<(), String> {
    output(Command::new("gcc").arg("--version")).map(drop)
}

pub(crate) fn compile(
    folders: &Folders,
    model: Model,
    source: &CSource,
    flags: Flags,
) -> Result<Compiled, String> {
    let name = source
        .name
        .replace(|letter: char| !letter.is_alphanumeric(), "_");
    let path = folders
        .output
        .join(format!("{name}_{model}_{}.so", flags.name()));
    let mut command = Command::new("gcc");
    command
        .args(flags.c())
        .args(["-shared", "-fPIC", &format!("-DN={}", model.degrees())])
        .arg(&source.path)
        .arg("-o")
        .arg(&path)
        .arg("-lm");
    let start = Instant::now();
    output(&mut command)?;
    let seconds = start.elapsed().as_secs_f64();
    Ok(Compiled { path, seconds })
}
