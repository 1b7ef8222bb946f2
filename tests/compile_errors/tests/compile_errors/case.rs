//! A declaration that has an error, with the messages that are expected.

use std::path::{Path, PathBuf};
use std::{env, fs};

use crate::entries;

/// A file of a folder of `ui/`.
pub(crate) struct Case {
    path: PathBuf,
}

impl Case {
    /// The cases whose path contains what the environment variable `CASES` says, in the order of their names.
    pub(crate) fn all() -> Vec<Self> {
        let wanted = env::var("CASES").unwrap_or_default();
        let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("ui");
        let files = entries(root).into_iter().flat_map(entries);
        let mut paths: Vec<PathBuf> = files
            .filter(|path| path.extension().is_some_and(|extension| extension == "rs"))
            .filter(|path| path.to_string_lossy().contains(&wanted))
            .collect();
        paths.sort();
        paths.into_iter().map(|path| Self { path }).collect()
    }

    pub(crate) fn path(&self) -> &Path {
        &self.path
    }

    /// The messages that are expected, if there is a file with them.
    pub(crate) fn expected(&self) -> Option<String> {
        fs::read_to_string(self.path.with_extension("stderr")).ok()
    }

    /// Whether all that is expected are messages of the derive: those of the compiler have numbers.
    pub(crate) fn is_of_the_derive_alone(&self) -> bool {
        let expected = self.expected();
        expected.is_some_and(|text| !text.contains("error[E"))
    }

    /// What is to be said if other messages are found; with `MESSAGES=overwrite`, they are from now on the expected ones.
    pub(crate) fn difference(&self, found: &str) -> Option<String> {
        let expected = self.expected().unwrap_or_default();
        if expected == found {
            return None;
        }
        if env::var_os("MESSAGES").is_some_and(|value| value == "overwrite") {
            fs::write(self.path.with_extension("stderr"), found).expect("the file of messages");
            return None;
        }
        let path = self.path.display();
        Some(format!("{path}\n\nEXPECTED:\n{expected}\nFOUND:\n{found}"))
    }
}
