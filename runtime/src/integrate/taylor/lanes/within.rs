//! Checks that the motions agree with their series within a step.

use super::attempt::Proposals;
use super::verdicts::Beyond;
use super::{TaylorLanes, any, both, lanes};
use crate::integrate::taylor::Series;
use crate::integrate::taylor::residual::Allowance;
use crate::limits::taylor::{INNER_CHECKS, NEGLIGIBLE_TERM};
use crate::linalg::LaneStates;
use crate::scalar::{Lanes, Scalar as _};

/// The motions in single lanes, each with its own equations.
pub(crate) trait SingleMotions<X, const L: usize> {
    /// Checks the step of a lane by the equations of its motion, in every lane. `None` if these are not known.
    fn check<const HALF: usize>(
        &self,
        step: StepOfLane<'_, X, L, HALF>,
    ) -> Option<Result<(), usize>>;
}

/// No equations of single motions.
impl<X, const L: usize> SingleMotions<X, L> for () {
    fn check<const HALF: usize>(&self, _: StepOfLane<'_, X, L, HALF>) -> Option<Result<(), usize>> {
        None
    }
}

/// A step of the motion in one lane.
pub(crate) struct StepOfLane<'a, X, const L: usize, const HALF: usize> {
    stepper: &'a mut TaylorLanes<X, L, HALF>,
    lane: usize,
    /// The signed length.
    h: f64,
    allowance: Allowance<Lanes<L>>,
}

impl<X: LaneStates<L>, const L: usize, const HALF: usize> StepOfLane<'_, X, L, HALF> {
    /// Returns the lane.
    pub(crate) fn lane(&self) -> usize {
        self.lane
    }

    /// Checks times within the step, as many at once as there are lanes, by the equations of its motion in every lane. The
    /// error is a component in which the polynomial differs from the motion.
    pub(crate) fn check<D>(self, equations: &D) -> Result<(), usize>
    where
        D: Series<Lanes<L>, State = X> + ?Sized,
    {
        let mut copies = self.stepper.copies_of(self.lane);
        let mut numbers = 1..=INNER_CHECKS;
        while !numbers.is_empty() {
            let batch: [Option<u32>; L] = core::array::from_fn(|_| numbers.next());
            let t = batch.map(|number| {
                let number = f64::from(number.unwrap_or(INNER_CHECKS));
                copies.time[0] + self.h * (number / f64::from(INNER_CHECKS + 1))
            });
            let asked = batch.map(|number| number.is_some());
            let reached = copies.at(&t);
            let beyond = copies.check_at(equations, (Lanes(t), &reached), &self.allowance, &asked);
            let first = beyond.and_then(|beyond| {
                let mut beyond = beyond.into_iter().enumerate();
                beyond.find_map(|(number, component)| Some((number, component?)))
            });
            // A single motion is not evaluated after the first difference.
            let evaluated = first.map_or(L, |(number, _)| number + 1);
            let statistics = copies.statistics.iter_mut().take(evaluated);
            self.stepper.statistics[self.lane].evaluations += statistics
                .map(|of| core::mem::take(of).evaluations)
                .sum::<u64>();
            if let Some((_, component)) = first {
                return Err(component);
            }
        }
        Ok(())
    }
}

impl<X: LaneStates<L>, const L: usize, const HALF: usize> TaylorLanes<X, L, HALF> {
    /// Returns the `asked` lanes whose steps of lengths `h` are so long, or of such a low degree, that the series may miss
    /// changes within them, or lie before the end of a rejected step.
    #[inline]
    pub(super) fn is_uncertain_within(
        &self,
        h: Lanes<L>,
        proposals: &Proposals<L>,
        asked: &[bool; L],
    ) -> [bool; L] {
        let middle = proposals.middle_at(h.abs(), Lanes(self.unit), HALF);
        let is_uncertain = core::array::from_fn(|lane| {
            let is_uncertain = self.uncertain[lane].contain(self.time[lane], h.0[lane]);
            // The terms of half the order are almost negligible.
            is_uncertain || middle.0[lane] < NEGLIGIBLE_TERM
        });
        both(&is_uncertain, asked)
    }

    /// Checks times within steps of lengths `h`, in the lanes that are asked for: in all lanes together, or lane by lane if
    /// no more than half of them are asked for and their equations are known.
    #[inline(never)]
    pub(super) fn check_within<D, M>(
        &mut self,
        (dynamics, motions): (&D, &M),
        (h, allowance): (Lanes<L>, &Allowance<Lanes<L>>),
        mut asked: [bool; L],
    ) -> Beyond<L>
    where
        D: Series<Lanes<L>, State = X> + ?Sized,
        M: SingleMotions<X, L>,
    {
        let mut beyond = [None; L];
        // A lane alone takes INNER_CHECKS/L evaluations, and copies.
        if 2 * lanes(&asked).count() <= L {
            for lane in lanes(&asked) {
                let step = StepOfLane {
                    h: h.0[lane],
                    allowance: allowance.of_lane(lane),
                    lane,
                    stepper: self,
                };
                if let Some(checked) = motions.check(step) {
                    (beyond[lane], asked[lane]) = (checked.err(), false);
                }
            }
        }
        for i in 1..=INNER_CHECKS {
            if !any(&asked) {
                break;
            }
            let part = Lanes::from_f64(f64::from(i) / f64::from(INNER_CHECKS + 1));
            let t = Lanes(self.time) + h * part;
            let Some(found) = self.check_at(dynamics, (t, &self.at(&t.0)), allowance, &asked)
            else {
                continue;
            };
            for lane in 0..L {
                if asked[lane] && found[lane].is_some() {
                    (beyond[lane], asked[lane]) = (found[lane], false);
                }
            }
        }
        beyond
    }

    /// Returns a stepper in which every lane has the state and the polynomial of this one, as if its motion began here.
    #[inline]
    fn copies_of(&self, lane: usize) -> Self {
        let state = self.state.in_every_lane(lane);
        let coefficients = self.coefficients.map(|x| X::broadcast(&x.lane(lane)));
        let time = self.time[lane];
        let mut copies = Self::with_coefficients(self.method, time, state, coefficients);
        copies.unit = [self.unit[lane]; L];
        copies
    }
}
