//! The ends of steps at discontinuity surfaces.

use crate::integrate::compensated::Compensated;
use crate::linalg::LaneStates;

/// The ends of the steps of some lanes at discontinuity surfaces.
pub(super) struct Arrivals<X, const L: usize> {
    /// The times; `None` for a step that ends elsewhere.
    pub(super) time: [Option<f64>; L],
    pub(super) state: Compensated<X>,
    /// The switching functions that are zero there.
    pub(super) function: [usize; L],
    pub(super) slides: [bool; L],
}

impl<X: LaneStates<L>, const L: usize> Arrivals<X, L> {
    /// Returns the time at which the step of a lane ends at a surface.
    pub(super) fn time(&self, lane: usize) -> Option<f64> {
        self.time.get(lane).copied().flatten()
    }

    /// Copies the states of the lanes whose steps end at a surface.
    pub(super) fn copy_to(&self, state: &mut Compensated<X>) {
        for lane in (0..L).filter(|&lane| self.time[lane].is_some()) {
            state.copy_lane(lane, &self.state);
        }
    }
}
