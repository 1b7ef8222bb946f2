//! The parts of an integration.

/// The position of a part within the whole integration.
#[derive(Clone, Copy, Debug)]
#[cfg_attr(not(feature = "alloc"), allow(dead_code))] // Keeping needs an allocator.
pub struct Part {
    /// The initial time of the problem, at which the grid of samples begins.
    pub(super) origin: f64,
    /// The end of the part.
    pub(super) end: f64,
    /// What the previous parts have kept.
    pub(super) kept: KeptSoFar,
    /// Whether the integration is in parts: samples after this one are left to the others.
    pub(super) is_one_of_several: bool,
}

/// The times up to which an integration has kept samples and steps.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct KeptSoFar {
    /// The time of the last sample.
    pub(super) sample: Option<f64>,
    /// The end of the last step.
    pub(super) step: Option<f64>,
}

impl Part {
    /// Returns the only part of an integration in one go.
    pub(super) fn whole(origin: f64, end: f64) -> Self {
        Self {
            origin,
            end,
            kept: KeptSoFar::default(),
            is_one_of_several: false,
        }
    }
}
