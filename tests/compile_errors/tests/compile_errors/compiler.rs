//! The compiler, called as it was for this test.

use std::collections::HashMap;
use std::fmt::Write as _;
use std::io::Write as _;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use lagrangian_compiler_arguments::compiler_arguments;
use serde_json::Value;

use crate::case::Case;
use crate::messages::{self, Message};

/// What the compiler says of a case.
pub(crate) fn compile(case: &Case) -> String {
    let source = std::fs::read_to_string(case.path()).expect("the file of the case");
    let mut command = command();
    command.arg(case.path());
    let found = run(command, "");
    assert!(!found.is_empty(), "this compiles:\n{source}");
    messages::text(&found)
}

/// What the compiler says of each of several cases, by their files, when they are modules of one crate.
///
/// The crate has errors that are found in the last steps, to show that these were reached. Otherwise nothing is returned.
pub(crate) fn compile_together(cases: &[Case]) -> HashMap<PathBuf, String> {
    let mut source = String::from(
        "fn main() {}\nfn wrong_type() -> u8 { \"\" }\nfn moved(s: String) -> [String; 2] { [s, s] }\n",
    );
    for (index, case) in cases.iter().enumerate() {
        let path = case.path().display().to_string();
        writeln!(source, "#[path = {path:?}] mod case_{index};").expect("strings grow");
    }
    let mut command = command();
    command.arg("-");
    let mut by_file: HashMap<PathBuf, Vec<Message>> = HashMap::new();
    for message in run(command, &source) {
        by_file
            .entry(message.file.clone())
            .or_default()
            .push(message);
    }
    let own = by_file.remove(Path::new("<anon>")).unwrap_or_default();
    let codes: Vec<&str> = own.iter().map(|message| message.code.as_str()).collect();
    if codes != ["E0308", "E0382"] {
        println!("cases were not checked together: {}", messages::text(&own));
        return HashMap::new();
    }
    let texts = by_file.into_iter();
    texts
        .map(|(file, found)| (file, messages::text(&found)))
        .collect()
}

/// The compiler with the libraries and the edition of this test, for a program of which nothing is written.
fn command() -> Command {
    let [program, arguments @ ..] = &compiler_arguments!();
    let mut command = Command::new(program);
    for pair in arguments.windows(2) {
        match pair {
            ["-L", folder] => {
                command.args(["-L", folder]);
            }
            ["--extern", library] if !library.contains("compiler_arguments") => {
                command.args(["--extern", library]);
            }
            [edition, _] if edition.starts_with("--edition") => {
                command.arg(edition);
            }
            _ => {}
        }
    }
    // Paths of the workspace's files are relative to its root in what is compiled, and hints differ for packages.
    command
        .current_dir(messages::workspace())
        .env("CARGO_CRATE_NAME", "case")
        .args(["--crate-type=bin", "--crate-name=case"])
        // Long types are written out.
        .arg("--verbose")
        .args(["--emit=metadata", "--error-format=json", "--out-dir"])
        .arg(env!("CARGO_TARGET_TMPDIR"));
    command
}

fn run(mut command: Command, input: &str) -> Vec<Message> {
    let pipes = command.stdin(Stdio::piped()).stderr(Stdio::piped());
    let mut process = pipes.spawn().expect("the compiler starts");
    let mut stdin = process.stdin.take().expect("it reads");
    stdin.write_all(input.as_bytes()).expect("it reads");
    drop(stdin);
    let output = process.wait_with_output().expect("the compiler ends");
    let lines = String::from_utf8(output.stderr).expect("messages are UTF-8");
    let values = lines.lines().map(|line| {
        serde_json::from_str::<Value>(line).unwrap_or_else(|_| panic!("the compiler says {line}"))
    });
    values.filter_map(|value| Message::read(&value)).collect()
}
