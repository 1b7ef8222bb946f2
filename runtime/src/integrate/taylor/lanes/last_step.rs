//! The last step of a lane, for a stepper that follows it.

use super::TaylorLanes;
use crate::integrate::compensated::Compensated;
use crate::integrate::taylor::interpolant::TaylorInterpolant;
use crate::linalg::LaneStates;

impl<X: LaneStates<L>, const L: usize, const HALF: usize> TaylorLanes<X, L, HALF> {
    /// Returns the state in a lane, with its compensation.
    pub(in crate::integrate::taylor) fn compensated(&self, lane: usize) -> Compensated<X::Lane> {
        self.state.lane(lane)
    }

    /// Copies the last step of a lane: its beginning, and its polynomial if that is requested.
    pub(in crate::integrate::taylor) fn copy_last_step(
        &self,
        lane: usize,
        step: &mut TaylorInterpolant<X::Lane, HALF>,
        with_polynomial: bool,
    ) {
        let (time, from, unit) = &self.previous;
        (step.time, step.unit) = (time[lane], unit[lane]);
        step.from = from.lane(lane);
        if with_polynomial {
            step.coefficients = self.coefficients.map(|states| states.lane(lane));
        }
    }
}
