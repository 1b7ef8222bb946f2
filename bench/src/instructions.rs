//! The instructions of programs, as valgrind counts them: they do not depend on what the machine does besides.

use std::path::Path;
use std::process::Command;

use crate::command::output;
use crate::folders::Folders;

/// The instructions of a program with these arguments, from the last line of what callgrind writes.
pub(crate) fn counted(
    folders: &Folders,
    program: &Path,
    arguments: &[String],
) -> Result<f64, String> {
    let path = folders.output.join("callgrind.out");
    output(
        Command::new("valgrind")
            .arg("--tool=callgrind")
            .arg(format!("--callgrind-out-file={}", path.display()))
            .arg(program)
            .args(arguments),
    )?;
    let text = std::fs::read_to_string(&path).map_err(|error| error.to_string())?;
    let total = text.lines().find_map(|line| line.strip_prefix("totals: "));
    let total = total.and_then(|total| total.trim().parse().ok());
    total.ok_or_else(|| format!("no total in {}", path.display()))
}
