//! What the derive says of declarations that have an error: each case of `ui/`, in a folder for its kind of
//! mistake, is compiled, and what the compiler prints is compared with the file beside it.
//!
//! The texts are those of the toolchain in use when they were written, Rust 1.95. After a change of
//! message, or of the toolchain, write them anew with `TRYBUILD=overwrite cargo test -p
//! lagrangian-compile-errors`, and read the difference. `-- each trybuild=forces/` runs one folder,
//! `-- each trybuild=force_twice` the cases of that name.

use std::ffi::OsStr;
use std::fs;
use std::path::{Path, PathBuf};

#[test]
fn each_error_stands_at_its_token_and_says_what_to_write() {
    trybuild::TestCases::new().compile_fail("ui/*/*.rs");
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
