//! Steps of lanes that are not accepted, and lanes that take no step.

use super::attempt::{Attempt, Expansion};
use super::verdicts::Verdict;
use super::{TaylorLanes, lanes};
use crate::integrate::error::IntegrationError;
use crate::integrate::taylor::Series;
use crate::linalg::LaneStates;
use crate::scalar::Lanes;

impl<X: LaneStates<L>, const L: usize, const HALF: usize> TaylorLanes<X, L, HALF> {
    /// Accepts or shortens the steps of the pending lanes.
    #[cold]
    pub(super) fn judge<D>(
        &mut self,
        dynamics: &D,
        attempt: &mut Attempt<X, L>,
        (expansion, verdicts): (&mut Expansion<X, L>, &[Verdict; L]),
        ends: &[f64; L],
    ) where
        D: Series<Lanes<L>, State = X> + ?Sized,
    {
        attempt.is_first = false;
        for lane in lanes(&attempt.pending) {
            let target = attempt.targets[lane];
            let judged = (lane, verdicts[lane], expansion.proposals);
            let times = (target, ends[lane]);
            let rejection = self.rejection(dynamics, judged, times, &mut attempt.arrivals);
            let Some((part, beyond)) = rejection else {
                attempt.pending[lane] = false;
                continue;
            };
            attempt.component[lane] = beyond.or(attempt.component[lane]);
            self.statistics[lane].rejected += 1;
            let length = (target - self.time[lane]).abs();
            attempt.lengths[lane] = match part {
                Some(part) => part * length,
                None => expansion.passed(lane).shortened(length),
            };
            if beyond.is_some() {
                let step = target - self.time[lane];
                self.uncertain[lane].reject(target, step);
                expansion.proposals.step[lane] = attempt.lengths[lane];
            }
        }
    }

    /// Stops the lanes whose steps are too small.
    #[cold]
    pub(super) fn stop_short<D>(
        &mut self,
        dynamics: &D,
        attempt: &mut Attempt<X, L>,
        is_too_small: &[bool; L],
    ) where
        D: Series<Lanes<L>, State = X> + ?Sized,
    {
        for lane in lanes(is_too_small) {
            self.too_small(
                dynamics,
                lane,
                attempt.lengths[lane],
                attempt.component[lane],
            );
            (attempt.moving[lane], attempt.pending[lane]) = (false, false);
            attempt.targets[lane] = self.time[lane];
        }
    }

    /// Stops the motions whose ends are not finite, and those that cannot leave a discontinuity surface.
    #[cold]
    pub(super) fn stop_some<D>(&mut self, dynamics: &D, ends: &[f64; L])
    where
        D: Series<Lanes<L>, State = X> + ?Sized,
    {
        for (lane, time) in ends.iter().copied().enumerate() {
            let remaining = time - self.time[lane];
            if self.errors[lane].is_none() && !remaining.is_finite() {
                self.fail(lane, IntegrationError::NonFiniteTime { time });
            }
            if remaining.abs() > 0.0 {
                self.stop_sliding(dynamics, lane);
            }
        }
    }
}
