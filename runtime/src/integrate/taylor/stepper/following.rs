//! Steppers that follow a motion in a lane.

use super::TaylorStepper;
use crate::integrate::stepper::Statistics;
use crate::integrate::taylor::TaylorLanes;
use crate::linalg::{LaneStates, VectorSpace};

impl<X: VectorSpace<f64>, const HALF: usize> TaylorStepper<X, HALF> {
    /// Whether no step was taken since the start, or since the stepper was restarted at a state.
    pub(crate) fn is_new(&self) -> bool {
        !self.has_last
    }

    /// Copies the last step of a lane, and adds its statistics to those of the motion before the lane was set. The
    /// polynomial is copied only on request; without it no state within the step is known.
    pub(crate) fn follow<Y, const L: usize>(
        &mut self,
        (lanes, lane): (&TaylorLanes<Y, L, HALF>, usize),
        before: Statistics,
        with_polynomial: bool,
    ) where
        Y: LaneStates<L, Lane = X>,
    {
        let [first, second] = &mut self.polynomials;
        let (present, last) = if self.exchanged {
            (second, first)
        } else {
            (first, second)
        };
        lanes.copy_last_step(lane, last, with_polynomial);
        (present.time, present.from) = (lanes.time(lane), lanes.compensated(lane));
        self.has_last = true;
        self.statistics = before.plus(lanes.statistics(lane));
    }

    /// Discards the last step, because none could be taken from here.
    pub(crate) fn forget_last_step(&mut self) {
        self.has_last = false;
    }
}
