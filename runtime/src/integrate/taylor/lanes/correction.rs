//! The correction of the ends of steps of motions in lanes.

use super::attempt::Attempt;
use super::{Reached, TaylorLanes, lanes};
use crate::integrate::taylor::coefficients::{divides, power};
use crate::linalg::{LaneStates, VectorSpace as _};
use crate::scalar::{Lanes, Scalar as _};

impl<X: LaneStates<L>, const L: usize, const HALF: usize> TaylorLanes<X, L, HALF> {
    /// Corrects the ends of the steps of the lanes that move, and changes their polynomials to end there, as
    /// [`TaylorStepper`](crate::TaylorStepper) does.
    #[inline]
    pub(super) fn correct(&mut self, attempt: &mut Attempt<X, L>, reached: &mut Reached<X, L>) {
        let Some(correction) = &mut attempt.correction else {
            return;
        };
        let mut highest = power(reached.tau, Self::ORDER);
        let is_uncorrected: [_; L] =
            core::array::from_fn(|lane| !attempt.moving[lane] | !divides(highest.0[lane]));
        for lane in lanes(&is_uncorrected) {
            correction.set_lane(lane, &correction.lane(lane).zeroed());
            highest.0[lane] = 1.0;
        }
        if let Some(last) = self.coefficients.higher_mut().last_mut() {
            last.add_scaled(Lanes::from_f64(1.0) / highest, correction);
        }
        reached.state = reached.state.plus(correction.clone());
    }
}
