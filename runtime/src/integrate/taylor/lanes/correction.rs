//! The correction of the ends of steps of motions in lanes.

use super::attempt::Attempt;
use super::{Reached, TaylorLanes, lanes};
use crate::linalg::{LaneStates, VectorSpace as _};

impl<X: LaneStates<L>, const L: usize, const HALF: usize> TaylorLanes<X, L, HALF> {
    /// Corrects the ends of the steps of the lanes that move, unless they end at discontinuity surfaces, and changes their
    /// polynomials to end there.
    #[inline]
    pub(super) fn correct(&mut self, attempt: &mut Attempt<X, L>, reached: &mut Reached<X, L>) {
        let Some(correction) = &mut attempt.correction else {
            return;
        };
        let mut is_uncorrected = attempt.moving.map(|moving| !moving);
        if let Some(arrivals) = &attempt.arrivals {
            for (is_uncorrected, time) in is_uncorrected.iter_mut().zip(&arrivals.time) {
                *is_uncorrected |= time.is_some();
            }
        }
        let mut tau = reached.tau;
        for lane in lanes(&is_uncorrected) {
            correction.set_lane(lane, &correction.lane(lane).zeroed());
            tau.0[lane] = 1.0;
        }
        self.coefficients.change_ends(tau, correction);
        reached.state = reached.state.plus(correction.clone());
    }
}
