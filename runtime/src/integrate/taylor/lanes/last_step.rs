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
            // In place, because a polynomial of the lane that is returned is copied twice.
            *step.coefficients.initial_mut() = self.coefficients.initial().lane(lane);
            let places = step.coefficients.higher_mut().iter_mut();
            for (place, states) in places.zip(self.coefficients.higher()) {
                *place = states.lane(lane);
            }
        }
    }
}
