//! The lanes of an ensemble: which motion each of them integrates.

use core::iter::Fuse;

use super::Ensemble;
use crate::integrate::at::At;
use crate::integrate::error::IntegrationError;
use crate::integrate::event::MetConditions;
use crate::integrate::outcome::{Outcome, StopReason};
use crate::integrate::problem::{Events, Solution};
use crate::integrate::singularity_check::singular;
use crate::integrate::taylor::{Series, TaylorLanes};
use crate::linalg::{LaneStates, VectorSpace};
use crate::scalar::Lanes;

/// An ensemble in progress.
pub(crate) struct Running<'a, X, I, R, const L: usize, const HALF: usize> {
    ensemble: &'a Ensemble<L, HALF>,
    /// None before the first motion.
    stepper: Option<TaylorLanes<X, L, HALF>>,
    waiting: Fuse<I>,
    exhausted: bool,
    /// How many motions have begun.
    begun: usize,
    /// The position of the motion in each lane; none where the lane is free.
    motions: [Option<usize>; L],
    ends: [f64; L],
    report: R,
}

impl<'a, X, I, R, const L: usize, const HALF: usize> Running<'a, X, I, R, L, HALF>
where
    X: LaneStates<L>,
    I: Iterator,
    R: FnMut(usize, Result<Solution<f64, X::Lane>, IntegrationError>),
{
    pub(crate) fn new(ensemble: &'a Ensemble<L, HALF>, motions: I, report: R) -> Self {
        Self {
            ensemble,
            stepper: None,
            waiting: motions.fuse(),
            exhausted: false,
            begun: 0,
            motions: [None; L],
            ends: [0.0; L],
            report,
        }
    }

    /// Gives each free lane a motion, whose initial value and final time `begin` tells. False when all motions have ended.
    pub(crate) fn fill(
        &mut self,
        mut begin: impl FnMut(usize, I::Item) -> (At<f64, X::Lane>, f64),
    ) -> bool {
        for lane in 0..L {
            if self.motions[lane].is_some() {
                continue;
            }
            let Some(motion) = self.waiting.next() else {
                self.exhausted = true;
                break;
            };
            let (initial, end) = begin(lane, motion);
            self.motions[lane] = Some(self.begun);
            self.ends[lane] = end;
            self.begun += 1;
            let method = self.ensemble.method;
            match &mut self.stepper {
                Some(stepper) => stepper.set_lane(lane, initial.t, &initial.x),
                stepper => {
                    // Lanes without a motion rest.
                    self.ends = [initial.t; L];
                    self.ends[lane] = end;
                    *stepper = Some(TaylorLanes::new(method, initial.t, &initial.x));
                }
            }
        }
        self.motions.iter().any(Option::is_some)
    }

    /// Takes steps until there is a free lane and a motion for it, or all have ended.
    pub(crate) fn advance<D>(&mut self, dynamics: &D)
    where
        D: Series<Lanes<L>, State = X> + ?Sized,
    {
        let Some(mut stepper) = self.stepper.take() else {
            return;
        };
        self.visit(dynamics, &mut stepper);
        loop {
            let mut busy = self.motions.iter().filter(|motion| motion.is_some());
            let count = busy.by_ref().count();
            if count == 0 || (count < L && !self.exhausted) {
                break;
            }
            stepper.step(dynamics, &self.ends);
            self.visit(dynamics, &mut stepper);
        }
        self.stepper = Some(stepper);
    }

    /// Reports the motions that have ended, and frees their lanes.
    fn visit<D>(&mut self, dynamics: &D, stepper: &mut TaylorLanes<X, L, HALF>)
    where
        D: Series<Lanes<L>, State = X> + ?Sized,
    {
        self.check_regular(dynamics, stepper);
        for lane in 0..L {
            let Some(motion) = self.motions[lane] else {
                continue;
            };
            let Some(result) = self.ended(lane, stepper) else {
                continue;
            };
            (self.report)(motion, result);
            self.motions[lane] = None;
            self.park(lane, stepper);
        }
    }

    /// The outcome or the error of the motion in a lane, if it has ended.
    fn ended(
        &self,
        lane: usize,
        stepper: &TaylorLanes<X, L, HALF>,
    ) -> Option<Result<Solution<f64, X::Lane>, IntegrationError>> {
        if let Some(error) = stepper.error(lane) {
            return Some(Err(error));
        }
        let (t, statistics) = (stepper.time(lane), stepper.statistics(lane));
        let steps = statistics.steps.saturating_add(statistics.rejected);
        let reason = if stepper.is_new(lane) {
            // The step will check it.
            return None;
        } else if t - self.ends[lane] == 0.0 {
            StopReason::Completed
        } else if steps >= self.ensemble.max_steps {
            StopReason::StepLimit
        } else {
            return None;
        };
        let x = stepper.state(lane);
        let outcome = Outcome {
            last: At { t, x },
            reason,
            met: MetConditions::default(),
            statistics,
        };
        Some(Ok(Solution::new((), Events::default(), outcome)))
    }

    /// Puts a free lane where a busy one is, so that it is at no singularity; it stays there.
    fn park(&mut self, lane: usize, stepper: &mut TaylorLanes<X, L, HALF>) {
        if let Some(busy) = self.motions.iter().position(Option::is_some) {
            let (time, state) = (stepper.time(busy), stepper.state(busy));
            stepper.set_lane(lane, time, &state);
            self.ends[lane] = time;
        }
    }

    /// Ends the motions that are too near to a singularity.
    fn check_regular<D>(&mut self, dynamics: &D, stepper: &mut TaylorLanes<X, L, HALF>)
    where
        D: Series<Lanes<L>, State = X> + ?Sized,
    {
        let min_pivot = match self.ensemble.min_pivot() {
            Ok(min_pivot) => min_pivot,
            Err(error) => return (0..L).for_each(|lane| stepper.fail(lane, error)),
        };
        let (times, states) = (stepper.times(), stepper.states());
        if dynamics.next_update(states).is_some() {
            return (0..L).for_each(|lane| stepper.fail(lane, IntegrationError::UpdatesInLanes));
        }
        let found = if (0..L).any(|lane| stepper.is_new(lane)) {
            dynamics.singularity(times, states, min_pivot)
        } else {
            dynamics.singularity_in_motion(times, states, min_pivot)
        };
        let before = stepper.previous_states();
        let pole = dynamics.singularity_between(None, before, (times, states));
        if min_pivot <= 0.0 || (found.is_none() && pole.is_none()) {
            return;
        }
        for lane in 0..L {
            let finite = stepper.state(lane).first_non_finite().is_none();
            if self.motions[lane].is_none() || stepper.error(lane).is_some() || !finite {
                continue;
            }
            let (before, states) = (stepper.previous_states(), stepper.states());
            let found = dynamics
                .singularity_between(Some(lane), before, (times, states))
                .or_else(|| dynamics.singularity_in_lane(lane, times, states, min_pivot));
            if let Some(singularity) = found {
                stepper.fail(lane, singular::<Lanes<L>>(stepper.time(lane), singularity));
            }
        }
    }
}
