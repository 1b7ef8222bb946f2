//! Whether motions are, at the end of a step and within it, those that their series say.

use super::{Reached, TaylorLanes, any, lanes, non_finite, number};
use crate::integrate::taylor::Series;
use crate::integrate::taylor::branch_crossings::BranchCrossings;
use crate::integrate::taylor::residual::{Allowance, Point};
use crate::integrate::taylor::step_size::power;
use crate::limits::events::MOST_COEFFICIENTS;
use crate::limits::taylor::{INNER_CHECKS, LONG_STEP, NEGLIGIBLE_TERM};
use crate::linalg::LaneStates;
use crate::scalar::{Lanes, Scalar};

/// For each lane the component that is not what the series says, if there is one.
type Beyond<const L: usize> = [Option<usize>; L];

impl<X: LaneStates<L>, const L: usize, const HALF: usize> TaylorLanes<X, L, HALF> {
    /// The checks of a step to `targets`, in the lanes that are `pending`, as those of
    /// [`TaylorStepper`](crate::TaylorStepper).
    pub(super) fn check<D>(
        &mut self,
        dynamics: &D,
        targets: &[f64; L],
        (reached, middle): (&Reached<X, L>, Lanes<L>),
        pending: &[bool; L],
    ) -> Beyond<L>
    where
        D: Series<Lanes<L>, State = X> + ?Sized,
    {
        let time = self.time;
        let h = Lanes(*targets) - Lanes(time);
        let mut beyond = self.check_at(dynamics, (Lanes(*targets), reached), h.abs(), pending);
        self.check_branches(dynamics, h, (reached.tau, pending), &mut beyond);
        // The terms of half the order hardly count there.
        let middle = middle * power(reached.tau.abs(), HALF);
        let low_degree = middle.0.map(|ratio| ratio < NEGLIGIBLE_TERM);
        let mut inner = core::array::from_fn(|lane| {
            let is_long = h.0[lane].abs() > LONG_STEP * self.length[lane];
            pending[lane] && beyond[lane].is_none() && (is_long || low_degree[lane])
        });
        for i in 1..=INNER_CHECKS {
            if !any(&inner) {
                break;
            }
            let part = Lanes::from_f64(f64::from(i) / f64::from(INNER_CHECKS + 1));
            let t = Lanes(time) + h * part;
            let found = self.check_at(dynamics, (t, &self.at(&t.0)), h.abs(), &inner);
            for lane in 0..L {
                if inner[lane] && found[lane].is_some() {
                    (beyond[lane], inner[lane]) = (found[lane], false);
                }
            }
        }
        beyond
    }

    /// The check behind each time within a step at which a motion passes to another branch of the equations. With too many of
    /// them, the first component is taken to be beyond, so that the step is shortened.
    fn check_branches<D>(
        &mut self,
        dynamics: &D,
        h: Lanes<L>,
        (tau, pending): (Lanes<L>, &[bool; L]),
        beyond: &mut Beyond<L>,
    ) where
        D: Series<Lanes<L>, State = X> + ?Sized,
    {
        let (t, unit) = (Lanes(self.time), Lanes(self.unit));
        let mut crossings = [BranchCrossings::NONE; L];
        let from = self.state.reduced(dynamics);
        dynamics.branches(t, &from, unit, &self.coefficients, &mut |argument| {
            let mut coefficients = [Lanes::from_f64(0.0); MOST_COEFFICIENTS];
            let mut count = 0;
            for (slot, coefficient) in coefficients.iter_mut().zip(argument) {
                *slot = coefficient;
                count += 1;
            }
            for (lane, crossings) in crossings.iter_mut().enumerate() {
                let of_lane = coefficients[..count].iter().map(|x| x.0[lane].into());
                crossings.add(of_lane, tau.0[lane], f64::EPSILON);
            }
        });
        for (beyond, crossings) in beyond.iter_mut().zip(&crossings) {
            *beyond = beyond.or(crossings.overflows().then_some(0));
        }
        let mut times = crossings.each_ref().map(BranchCrossings::times_between);
        loop {
            let parts = times.each_mut().map(Iterator::next);
            let asked = core::array::from_fn(|lane| {
                pending[lane] && beyond[lane].is_none() && parts[lane].is_some()
            });
            if !any(&asked) {
                return;
            }
            let t = t + h * Lanes(parts.map(|part| part.unwrap_or(1.0)));
            let found = self.check_at(dynamics, (t, &self.at(&t.0)), h.abs(), &asked);
            for lane in lanes(&asked) {
                beyond[lane] = beyond[lane].or(found[lane]);
            }
        }
    }

    /// The check at one time in each lane, for steps of the lengths `h`. Rounding explains a difference, and the tolerance
    /// does.
    fn check_at<D>(
        &mut self,
        dynamics: &D,
        (t, reached): (Lanes<L>, &Reached<X, L>),
        h: Lanes<L>,
        pending: &[bool; L],
    ) -> Beyond<L>
    where
        D: Series<Lanes<L>, State = X> + ?Sized,
    {
        let unit = Lanes::from_f64(1.0) / Lanes(self.unit);
        let point = Point {
            t,
            state: reached.state.reduced(dynamics),
            slope: reached.slope.map(|component| component * unit),
        };
        let allowance = Allowance {
            h,
            order: number(Self::ORDER),
            tolerance: self.tolerance(h),
        };
        let derivative = dynamics.derivative(t, &point.state);
        let [residual, mut allowed] = allowance.residual(dynamics, &point, &derivative);
        for lane in lanes(pending) {
            self.statistics[lane].evaluations += 1;
        }
        let mut failing = exceeds(&residual, &allowed, pending);
        if any(&failing) {
            allowance.allow_condition(dynamics, &point, &derivative, &mut allowed);
            for lane in lanes(&failing) {
                self.statistics[lane].evaluations += 2;
            }
            failing = exceeds(&residual, &allowed, &failing);
        }
        core::array::from_fn(|lane| {
            failing[lane].then(|| match non_finite(reached.state.value(), lane) {
                Some((index, _)) => index,
                None => first_beyond(&residual, &allowed, lane),
            })
        })
    }
}

/// The lanes, of those that are asked for, in which a component is not at most what is allowed; one that is not finite is
/// not.
fn exceeds<X: LaneStates<L>, const L: usize>(
    residual: &X,
    allowed: &X,
    asked: &[bool; L],
) -> [bool; L] {
    let mut excess = Lanes::from_f64(0.0);
    for (residual, allowed) in residual.components().zip(allowed.components()) {
        // Twice the excess, or 0, or NaN.
        let over = residual - allowed;
        excess += over + over.abs();
    }
    core::array::from_fn(|lane| asked[lane] && (excess.0[lane].is_nan() || excess.0[lane] > 0.0))
}

/// The first component of a lane that is not at most what is allowed.
#[cold]
fn first_beyond<X: LaneStates<L>, const L: usize>(residual: &X, allowed: &X, lane: usize) -> usize {
    let mut pairs = residual.components().zip(allowed.components());
    let found = pairs.position(|(residual, allowed)| {
        let excess = residual.lane(lane) - allowed.lane(lane);
        excess.is_nan() || excess > 0.0
    });
    found.unwrap_or(0)
}
