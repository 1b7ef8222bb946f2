//! The parts of an integration.

/// Where a part of an integration lies in the whole of it.
#[derive(Clone, Copy, Debug)]
#[cfg_attr(not(feature = "alloc"), allow(dead_code))] // What is kept is allocated.
pub struct Part {
    /// The time at which the problem begins, and with it the grid of samples.
    pub(super) origin: f64,
    /// The time at which the part ends.
    pub(super) end: f64,
    /// What the parts before have kept.
    pub(super) kept: KeptSoFar,
    /// Whether the integration is in parts: samples beyond this one wait for the others.
    pub(super) is_one_of_several: bool,
}

/// The times up to which an integration has kept what is asked for.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct KeptSoFar {
    /// The last sample.
    pub(super) sample: Option<f64>,
    /// The end of the last step.
    pub(super) step: Option<f64>,
}

impl Part {
    /// The integration of a problem in one go.
    pub(super) fn whole(origin: f64, end: f64) -> Self {
        Self {
            origin,
            end,
            kept: KeptSoFar::default(),
            is_one_of_several: false,
        }
    }
}
