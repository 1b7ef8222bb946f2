//! Errors of studies.

use std::error;
use std::fmt;
#[cfg(any(feature = "csv", feature = "parquet"))]
use std::io;
#[cfg(any(feature = "csv", feature = "parquet"))]
use std::path::{Path, PathBuf};

/// An error of a study as a whole. A member that fails is no error of the study, but a [`Failure`](crate::Failure).
#[non_exhaustive]
pub enum Error {
    /// There are no members.
    NoMembers,
    /// The points are invalid; the text says why.
    Points(String),
    /// The columns are invalid; the text says why.
    Columns(String),
    /// The metadata are invalid; the text says why.
    Metadata(String),
    /// There is no such shard; the text says why.
    Shard(String),
    /// The threads could not be started.
    Threads(rayon::ThreadPoolBuildError),
    /// A file could not be read or written.
    #[cfg(any(feature = "csv", feature = "parquet"))]
    File {
        /// Its path.
        path: PathBuf,
        /// What was to be done with it.
        action: &'static str,
        /// The error.
        source: io::Error,
    },
    /// A folder contains something other than the results of this study; the text says what to do.
    #[cfg(feature = "parquet")]
    Folder {
        /// Its path.
        path: PathBuf,
        /// What it contains instead, and what to do.
        text: String,
    },
}

impl Error {
    /// Returns a function that adds the path and the action to an error of input and output.
    #[cfg(any(feature = "csv", feature = "parquet"))]
    pub(crate) fn file<E: Into<Box<dyn error::Error + Send + Sync>>>(
        path: &Path,
        action: &'static str,
    ) -> impl FnOnce(E) -> Self {
        let path = path.to_path_buf();
        move |source| {
            let source: Box<dyn error::Error + Send + Sync> = source.into();
            let source = match source.downcast::<io::Error>() {
                Ok(source) => *source,
                Err(source) => io::Error::other(source),
            };
            Self::File {
                path,
                action,
                source,
            }
        }
    }
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NoMembers => f.write_str("the study has no members"),
            Self::Points(text) | Self::Columns(text) | Self::Metadata(text) | Self::Shard(text) => {
                f.write_str(text)
            }
            Self::Threads(error) => write!(f, "the threads could not be started: {error}"),
            #[cfg(any(feature = "csv", feature = "parquet"))]
            Self::File {
                path,
                action,
                source,
            } => write!(f, "{} could not be {action}: {source}", path.display()),
            #[cfg(feature = "parquet")]
            Self::Folder { path, text } => write!(f, "the folder {}: {text}", path.display()),
        }
    }
}

/// The message, which `main` prints when it returns an error.
impl fmt::Debug for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(self, f)
    }
}

impl error::Error for Error {
    fn source(&self) -> Option<&(dyn error::Error + 'static)> {
        match self {
            Self::Threads(error) => Some(error),
            #[cfg(any(feature = "csv", feature = "parquet"))]
            Self::File { source, .. } => Some(source),
            _ => None,
        }
    }
}
