//! What the derive says of declarations that have an error: each case of `ui/`, in a folder for its kind of
//! mistake, is compiled, and what the compiler prints is compared with the file beside it.
//!
//! The texts are those of the toolchain in use when they were written, Rust 1.95. After a change of
//! message, or of the toolchain, write them anew with `MESSAGES=overwrite cargo test -p
//! lagrangian-compile-errors`, and read the difference. `CASES=forces/` in front of the command runs one
//! folder, `CASES=force_twice` the cases of that name.
//!
//! To start the compiler and to load the libraries costs more than a case. Cases of which the derive alone has something to say are
//! therefore modules of one crate, and each message belongs to the case in whose file it stands. A case for which the compiler
//! should say something else than in the file beside it is compiled by itself, and that counts; so is a case with errors
//! of the compiler's own, which name types and traits of other modules.

mod case;
mod compiler;
mod messages;

use std::collections::VecDeque;
use std::ffi::OsStr;
use std::fs;
use std::path::{Path, PathBuf};
use std::sync::Mutex;
use std::thread;

use case::Case;

#[test]
fn each_error_stands_at_its_token_and_says_what_to_write() {
    let cases = Case::all();
    assert!(!cases.is_empty(), "no case has this name");
    let (together, apart): (Vec<Case>, Vec<Case>) =
        cases.into_iter().partition(Case::is_of_the_derive_alone);
    let processes = thread::available_parallelism().map_or(1, usize::from);
    let groups = together.chunks(together.len().div_ceil(processes).max(1));
    let mut jobs: VecDeque<&[Case]> = groups.collect();
    jobs.extend(apart.chunks(1));

    let jobs = Mutex::new(jobs);
    let differences = Mutex::new(Vec::new());
    thread::scope(|scope| {
        for _ in 0..processes {
            scope.spawn(|| {
                loop {
                    let Some(job) = jobs.lock().unwrap().pop_front() else {
                        break;
                    };
                    let found = differing(job);
                    differences.lock().unwrap().extend(found);
                }
            });
        }
    });
    let mut differences = differences.into_inner().unwrap();
    differences.sort();
    assert!(
        differences.is_empty(),
        "{} cases have other messages:\n\n{}",
        differences.len(),
        differences.join("\n")
    );
}

/// What is to be said of those of the cases whose messages are not the expected ones.
fn differing(cases: &[Case]) -> Vec<String> {
    let mut suspects: Vec<&Case> = cases.iter().collect();
    if cases.len() > 1 {
        let found = compiler::compile_together(cases);
        suspects.retain(|case| case.expected() != found.get(case.path()).cloned());
    }
    let differences = suspects.into_iter().map(|case| {
        let found = compiler::compile(case);
        case.difference(&found)
    });
    differences.flatten().collect()
}

#[test]
fn a_folder_holds_cases_with_their_messages_and_nothing_else() {
    for folder in entries("ui") {
        assert!(folder.is_dir(), "{} is in no folder", folder.display());
        for case in entries(&folder) {
            let pair = match case.extension().and_then(OsStr::to_str) {
                Some("rs") => case.with_extension("stderr"),
                Some("stderr") => case.with_extension("rs"),
                _ => panic!("{} is no case", case.display()),
            };
            assert!(pair.is_file(), "{} is missing", pair.display());
        }
    }
}

fn entries(folder: impl AsRef<Path>) -> Vec<PathBuf> {
    let entries = fs::read_dir(folder).unwrap();
    entries.map(|entry| entry.unwrap().path()).collect()
}
