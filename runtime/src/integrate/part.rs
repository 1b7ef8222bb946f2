//! The parts of an integration.

/// The position of a part within the whole integration.
#[derive(Clone, Copy, Debug)]
#[cfg_attr(not(feature = "alloc"), allow(dead_code))] // Keeping needs an allocator.
pub struct Part {
    /// The initial time of the problem, at which the grid of samples begins.
    pub(crate) origin: f64,
    /// The end of the part.
    pub(crate) end: f64,
    /// What the previous parts have kept.
    pub(crate) kept: KeptSoFar,
    /// Whether the integration is in parts: samples after this one are left to the others.
    pub(crate) is_one_of_several: bool,
}

/// The times up to which an integration has kept samples and steps.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct KeptSoFar {
    /// The time of the last sample.
    pub(crate) sample: Option<f64>,
    /// The end of the last step.
    pub(crate) step: Option<f64>,
}

impl Part {
    /// Returns the only part of an integration in one go.
    pub(crate) fn whole(origin: f64, end: f64) -> Self {
        Self {
            origin,
            end,
            kept: KeptSoFar::default(),
            is_one_of_several: false,
        }
    }
}
