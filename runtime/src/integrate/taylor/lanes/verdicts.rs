//! The results of the checks of steps in lanes.

use super::{lanes, non_finite};
use crate::integrate::taylor::branch_crossings::{BranchCrossings, Crossing};
use crate::linalg::LaneStates;
use crate::scalar::{Lanes, Scalar};

/// For each lane the component that disagrees with the series, if there is one.
pub(super) type Beyond<const L: usize> = [Option<usize>; L];

/// The result of the check that the polynomial of a lane is the motion within a step.
#[derive(Clone, Copy)]
pub(super) enum Verdict {
    Agrees,
    /// The polynomial differs from the motion in this component.
    Differs(usize),
    /// The step is to be tried with this fraction of its length: the series of all switching functions converge in it, or the
    /// step ends at a singular configuration that was not found.
    Shorten(f64),
    /// The polynomial differs from the motion after a sign change of a switching function.
    Crosses(Crossing),
}

/// The verdicts of all lanes, until each check has been made.
pub(super) struct Verdicts<const L: usize> {
    pub(super) of_lanes: [Verdict; L],
    /// The lanes of which no check has failed.
    pub(super) open: [bool; L],
}

impl<const L: usize> Verdicts<L> {
    /// The verdicts of these lanes before the first check.
    #[inline]
    pub(super) fn of(pending: &[bool; L]) -> Self {
        Self {
            of_lanes: [Verdict::Agrees; L],
            open: *pending,
        }
    }

    /// Records the verdict of a check that has failed.
    pub(super) fn put(&mut self, lane: usize, verdict: Verdict) {
        (self.of_lanes[lane], self.open[lane]) = (verdict, false);
    }

    /// Checks that the states are finite.
    #[inline]
    pub(super) fn need_finite<X: LaneStates<L>>(&mut self, states: &X) {
        // A sum of zeros, or NaN if a component is not finite.
        let zero = states.fold(Lanes::from_f64(0.0), |sum, component| {
            component.mul_add(Lanes::from_f64(0.0), sum)
        });
        if !zero.is_finite() {
            self.put_non_finite(states);
        }
    }

    #[cold]
    fn put_non_finite<X: LaneStates<L>>(&mut self, states: &X) {
        for lane in lanes(&self.open) {
            if let Some((index, _)) = non_finite(states, lane) {
                self.put(lane, Verdict::Differs(index));
            }
        }
    }

    /// Records the components in which polynomials differ from the motions at the ends of steps. A switching function
    /// that changes its sign there explains it.
    #[cold]
    pub(super) fn put_ends(&mut self, found: &Beyond<L>, crossings: Option<&[BranchCrossings; L]>) {
        for lane in lanes(&self.open) {
            let at_end = crossings.and_then(|of| of[lane].at_end);
            match (found[lane], at_end) {
                (None, _) => (),
                (Some(_), Some(function)) => {
                    self.put(lane, Verdict::Crosses(Crossing { at: 1.0, function }));
                }
                (Some(component), None) => self.put(lane, Verdict::Differs(component)),
            }
        }
    }

    /// Records the components in which polynomials differ from the motions within steps.
    pub(super) fn put_differences(&mut self, found: &Beyond<L>) {
        for lane in lanes(&self.open) {
            if let Some(component) = found[lane] {
                self.put(lane, Verdict::Differs(component));
            }
        }
    }
}
