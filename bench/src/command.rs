//! Running other programs.

use std::process::Command;

/// Runs a program to its end: what it prints, or what went wrong, in one line.
pub(crate) fn output(command: &mut Command) -> Result<String, String> {
    let program = command.get_program().to_string_lossy().into_owned();
    let output = command
        .output()
        .map_err(|error| format!("`{program}` cannot be run: {error}"))?;
    if output.status.success() {
        return Ok(String::from_utf8_lossy(&output.stdout).into_owned());
    }
    let complaint = String::from_utf8_lossy(&output.stderr).into_owned()
        + &String::from_utf8_lossy(&output.stdout);
    Err(format!("`{program}` failed: {}", telling(&complaint)))
}

/// The line of a complaint that says most: the first that is an error, or else the last.
fn telling(complaint: &str) -> &str {
    let mut lines = complaint
        .lines()
        .map(str::trim)
        .filter(|line| !line.is_empty());
    let is_error = |line: &&str| {
        let line = line.to_lowercase();
        line.starts_with("error") || line.contains(" error: ")
    };
    let error = lines.clone().find(is_error);
    error
        .or_else(|| lines.next_back())
        .unwrap_or("it does not say why")
}
