//! Every program of the guide runs, and prints what its chapter shows.
//!
//! `OUTPUT=overwrite cargo test -p lagrangian-guide` writes the outputs and figures anew.

use std::path::{Path, PathBuf};
use std::process::Command;
use std::{env, fs};

/// The folder of the chapters.
fn docs() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR"))
        .parent()
        .expect("the package is in the folder of the chapters")
        .into()
}

/// Runs a program and compares what it prints with `output/NAME.txt`.
fn check(name: &str, program: &str) {
    let overwrite = env::var_os("OUTPUT").is_some_and(|value| value == "overwrite");
    let mut command = Command::new(program);
    if overwrite {
        command.arg(docs().join("figures"));
    }
    let run = command
        .output()
        .unwrap_or_else(|error| panic!("{program}: {error}"));
    assert!(
        run.status.success(),
        "{name}: {}",
        String::from_utf8_lossy(&run.stderr)
    );
    let printed = String::from_utf8(run.stdout).expect("programs print text");
    let path = docs()
        .join("programs/output")
        .join(name)
        .with_extension("txt");
    if overwrite {
        fs::write(&path, &printed).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
    }
    let expected =
        fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
    assert_eq!(
        printed, expected,
        "{name}: OUTPUT=overwrite writes the new output"
    );
}

macro_rules! programs {
    ($($name:ident),* $(,)?) => {
        $(
            #[test]
            fn $name() {
                check(stringify!($name), env!(concat!("CARGO_BIN_EXE_", stringify!($name))));
            }
        )*

        /// No program is left out of this list.
        #[test]
        fn all_programs_are_listed() {
            let mut found: Vec<String> = fs::read_dir(docs().join("programs/src/bin"))
                .expect("the programs have a folder")
                .map(|entry| entry.expect("the folder is read").path())
                .filter_map(|path| Some(path.file_stem()?.to_str()?.to_owned()))
                .collect();
            found.sort();
            let mut listed = [$(stringify!($name)),*];
            listed.sort_unstable();
            assert_eq!(found, listed);
        }
    };
}

programs! {
    introduction,
    declare,
    page,
    simulate,
    watch,
    control,
    constrain,
    linearize,
    identify,
    many,
    encoder,
    equations,
    furuta,
    single_precision,
}
