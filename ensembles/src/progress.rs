//! How far a study has come.

/// Members that have ended.
pub(crate) struct Ended {
    pub(crate) ended: usize,
    /// Those of them that have failed.
    pub(crate) failed: usize,
}

/// The progress of a study.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Progress {
    /// The number of members that have ended, including those that failed.
    pub ended: usize,
    /// The number of members that have failed.
    pub failed: usize,
    /// The number of all members that this run integrates.
    pub members: usize,
}
