//! What is known of one side of a comparison.

use std::path::PathBuf;

/// One line of the table.
#[derive(Clone, Debug, Default)]
pub(crate) struct Side {
    pub(crate) name: String,
    pub(crate) native: Times,
    pub(crate) default: Times,
    pub(crate) operations: Option<usize>,
    pub(crate) derive_seconds: Option<f64>,
    pub(crate) compile_seconds: Option<f64>,
    /// The greatest relative difference from ours.
    pub(crate) difference: Option<f64>,
}

/// Nanoseconds of an evaluation.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Times {
    pub(crate) throughput: Option<f64>,
    pub(crate) latency: Option<f64>,
}

/// A peer in C, not yet compiled.
pub(crate) struct CSource {
    pub(crate) name: String,
    pub(crate) path: PathBuf,
    pub(crate) operations: Option<usize>,
    pub(crate) derive_seconds: Option<f64>,
}
