//! Messages of the compiler as text that is the same on every machine.

use std::path::{Path, PathBuf};

use serde_json::Value;

/// A message about a place in a file.
pub(crate) struct Message {
    /// The file in which it stands.
    pub(crate) file: PathBuf,
    /// The number of the compiler's own errors, such as `E0308`.
    pub(crate) code: String,
    rendered: String,
}

impl Message {
    /// A message as the compiler writes it; none if it is about no place, as is the number of errors at the end.
    pub(crate) fn read(value: &Value) -> Option<Self> {
        let spans = value["spans"].as_array()?;
        let span = spans.iter().find(|span| span["is_primary"] == true)?;
        let file = span["file_name"].as_str()?;
        Some(Self {
            file: PathBuf::from(file),
            code: value["code"]["code"].as_str().unwrap_or_default().into(),
            rendered: value["rendered"].as_str()?.into(),
        })
    }
}

/// Messages one after the other.
pub(crate) fn text(messages: &[Message]) -> String {
    let texts = messages.iter().map(|message| portable(&message.rendered));
    texts.collect::<Vec<_>>().join("\n")
}

/// A message without what depends on the machine, or on lines of files that are not the case's.
fn portable(rendered: &str) -> String {
    let package = slashes(Path::new(env!("CARGO_MANIFEST_DIR")));
    let workspace = slashes(&workspace());
    let mut lines = Vec::new();
    let (mut margin, mut digits, mut elsewhere) = (0, 0, false);
    for line in rendered.trim_end().lines().map(str::trim_end) {
        if let Some((arrow, place)) = place_of(line) {
            margin = arrow.len() - "--> ".len();
            let place = place.replace('\\', "/");
            let own = place.strip_prefix(&package).map(|rest| &rest[1..]);
            elsewhere = own.is_none();
            let place = own.map_or_else(|| place_elsewhere(&place, &workspace), str::to_owned);
            lines.push(format!("{arrow}{place}"));
        } else if elsewhere {
            lines.push(without_number(line).replace(&package, "$DIR"));
        } else {
            digits = digits.max(number(line).unwrap_or_default().len());
            lines.push(line.replace(&package, "$DIR"));
        }
    }
    // The margin has room for the longest number, which may be that of a line of another file.
    let superfluous = " ".repeat(margin.saturating_sub(digits.max(1)));
    let texts = lines.iter().map(|line| {
        let (omission, rest) = line.split_at(if line.starts_with("...") { 3 } else { 0 });
        let rest = rest.strip_prefix(&superfluous).unwrap_or(rest);
        format!("{omission}{rest}\n")
    });
    texts.collect()
}

/// A line with a place, after its arrow.
fn place_of(line: &str) -> Option<(&str, &str)> {
    let start = line.trim_start();
    let place = start
        .strip_prefix("--> ")
        .or_else(|| start.strip_prefix("::: "))?;
    Some(line.split_at(line.len() - place.len()))
}

/// The folder of the workspace.
pub(crate) fn workspace() -> PathBuf {
    let package = Path::new(env!("CARGO_MANIFEST_DIR"));
    package.join("../..").canonicalize().expect("a workspace")
}

/// A file without line and column, of the workspace or of Rust's library.
fn place_elsewhere(place: &str, workspace: &str) -> String {
    let mut parts = place.rsplitn(3, ':').skip(2);
    let file = parts.next().unwrap_or(place);
    if let Some(rest) = file.strip_prefix(workspace) {
        return format!("$WORKSPACE{rest}");
    }
    // Where the compiler has the sources of Rust's library, and where it has not.
    let installed = file.split_once("/rustlib/src/rust/library");
    let built = || file.strip_prefix("/rustc/")?.split_once("/library");
    if let Some((_, rest)) = installed.or_else(built) {
        return format!("$RUST{rest}");
    }
    if Path::new(file).is_relative() {
        return format!("$WORKSPACE/{file}");
    }
    match file.split_once("/registry/src/") {
        Some((_, rest)) => format!(
            "$CARGO/{}",
            rest.split_once('/').map_or(rest, |(_, path)| path)
        ),
        None => file.to_owned(),
    }
}

/// The number of a line of source code.
fn number(line: &str) -> Option<&str> {
    let (number, _) = line.trim_start().split_once(" |")?;
    let digits = number.bytes().all(|byte| byte.is_ascii_digit());
    (digits && !number.is_empty()).then_some(number)
}

/// A line of source code with blanks in place of its number.
fn without_number(line: &str) -> String {
    number(line).map_or_else(
        || line.to_owned(),
        |number| line.replacen(number, &" ".repeat(number.len()), 1),
    )
}

fn slashes(path: &Path) -> String {
    path.display().to_string().replace('\\', "/")
}
