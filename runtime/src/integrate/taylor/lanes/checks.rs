//! Checks that the motions agree with their series at the end of a step and within it.

use super::{Reached, TaylorLanes, any, lanes, non_finite, number};
use crate::integrate::taylor::Series;
use crate::integrate::taylor::branch_crossings::{BranchCrossings, Crossing, SearchedStep};
use crate::integrate::taylor::residual::{Allowance, Point};
use crate::integrate::taylor::singular_configuration::SingularConfiguration;
use crate::integrate::taylor::step_size::power;
use crate::limits::events::MAX_COEFFICIENTS;
use crate::limits::taylor::{
    INNER_CHECKS, LONG_STEP, NEGLIGIBLE_TERM, RESIDUAL_ROUNDING, RESOLUTION,
};
use crate::linalg::LaneStates;
use crate::scalar::{Lanes, Scalar};

/// For each lane the component that disagrees with the series, if there is one.
type Beyond<const L: usize> = [Option<usize>; L];

/// The result of the check that the polynomial of a lane is the motion within a step.
#[derive(Clone, Copy)]
pub(super) enum Verdict {
    Agrees,
    /// The polynomial differs from the motion in this component.
    Differs(usize),
    /// The polynomial is known only in this fraction of the step, in which the series of all switching functions
    /// converge.
    Converges(f64),
    /// The polynomial differs from the motion after a sign change of a switching function.
    Crosses(Crossing),
}

impl<X: LaneStates<L>, const L: usize, const HALF: usize> TaylorLanes<X, L, HALF> {
    /// Checks a step to `targets` in the lanes that are `pending`, as [`TaylorStepper`](crate::TaylorStepper) does.
    pub(super) fn check<D>(
        &mut self,
        dynamics: &D,
        targets: &[f64; L],
        (reached, middle, passed): (&Reached<X, L>, Lanes<L>, &[SingularConfiguration; L]),
        pending: &[bool; L],
    ) -> [Verdict; L]
    where
        D: Series<Lanes<L>, State = X> + ?Sized,
    {
        let time = self.time;
        let h = Lanes(*targets) - Lanes(time);
        let mut verdicts = [Verdict::Agrees; L];
        // Lanes without a verdict.
        let mut open = *pending;
        let state = reached.state.value();
        // A sum of zeros, or NaN if a component is not finite.
        let zero = state.fold(Lanes::from_f64(0.0), |sum, component| {
            component.mul_add(Lanes::from_f64(0.0), sum)
        });
        for lane in lanes(pending).filter(|&lane| !zero.0[lane].is_finite()) {
            if let Some((index, _)) = non_finite(state, lane) {
                (verdicts[lane], open[lane]) = (Verdict::Differs(index), false);
            }
        }
        let crossings = self.crossings(dynamics, h, reached.tau, &open);
        if let Some(crossings) = &crossings {
            for lane in lanes(&open) {
                if crossings[lane].converging < 1.0 {
                    verdicts[lane] = Verdict::Converges(crossings[lane].converging);
                    open[lane] = false;
                }
            }
            self.check_crossings(dynamics, h, crossings, (&mut verdicts, &mut open));
        }
        if !any(&open) {
            return verdicts;
        }
        let mut allowance = self.allowance(h.abs());
        allowance.roundings *=
            Lanes::from_fn(|lane| passed[lane].growth(h.0[lane].abs(), Self::ORDER));
        let found = self.check_at(dynamics, (Lanes(*targets), reached), &allowance, &open);
        for lane in lanes(&open) {
            if let Some(component) = found[lane] {
                open[lane] = false;
                let at_end = crossings.as_ref().and_then(|of| of[lane].at_end);
                verdicts[lane] = match at_end {
                    Some(function) => Verdict::Crosses(Crossing { at: 1.0, function }),
                    None => Verdict::Differs(component),
                };
            }
        }
        let mut inner = self.is_uncertain_within(h, (reached.tau, middle), &open);
        if let Some(crossings) = &crossings {
            for lane in lanes(&open) {
                inner[lane] |= crossings[lane].has_noise;
            }
        }
        let found = self.check_within(dynamics, (h, &allowance), inner);
        for lane in lanes(&open) {
            if let Some(component) = found[lane] {
                verdicts[lane] = Verdict::Differs(component);
            }
        }
        verdicts
    }

    /// Returns those of the `asked` lanes whose steps of lengths `h` are so long, or of such a low degree, that the
    /// series may miss changes within them.
    pub(super) fn is_uncertain_within(
        &self,
        h: Lanes<L>,
        (tau, middle): (Lanes<L>, Lanes<L>),
        asked: &[bool; L],
    ) -> [bool; L] {
        // The terms of half the order are almost negligible there.
        let middle = middle * power(tau.abs(), HALF);
        core::array::from_fn(|lane| {
            let is_long = h.0[lane].abs() > LONG_STEP * self.length[lane];
            asked[lane] && (is_long || middle.0[lane] < NEGLIGIBLE_TERM)
        })
    }

    /// Checks times within steps of lengths `h`, in the lanes that are asked for.
    pub(super) fn check_within<D>(
        &mut self,
        dynamics: &D,
        (h, allowance): (Lanes<L>, &Allowance<Lanes<L>>),
        mut asked: [bool; L],
    ) -> Beyond<L>
    where
        D: Series<Lanes<L>, State = X> + ?Sized,
    {
        let mut beyond = [None; L];
        for i in 1..=INNER_CHECKS {
            if !any(&asked) {
                break;
            }
            let part = Lanes::from_f64(f64::from(i) / f64::from(INNER_CHECKS + 1));
            let t = Lanes(self.time) + h * part;
            let found = self.check_at(dynamics, (t, &self.at(&t.0)), allowance, &asked);
            for lane in 0..L {
                if asked[lane] && found[lane].is_some() {
                    (beyond[lane], asked[lane]) = (found[lane], false);
                }
            }
        }
        beyond
    }

    /// Returns the sign changes of switching functions in the steps of the lanes that are asked for; `None` if there are no
    /// switching functions.
    fn crossings<D>(
        &self,
        dynamics: &D,
        h: Lanes<L>,
        tau: Lanes<L>,
        asked: &[bool; L],
    ) -> Option<[BranchCrossings; L]>
    where
        D: Series<Lanes<L>, State = X> + ?Sized,
    {
        let (t, unit) = (Lanes(self.time), Lanes(self.unit));
        if !any(asked) {
            return None;
        }
        let none = || {
            core::array::from_fn(|lane| {
                let (time, h) = (self.time[lane].abs(), h.0[lane].abs());
                BranchCrossings::none(RESOLUTION * f64::EPSILON * (time + h) / h)
            })
        };
        let mut crossings: Option<[BranchCrossings; L]> = None;
        let motion = &self.coefficients;
        let from = self.state.reduced(dynamics);
        dynamics.branches(t, &from, unit, motion, &mut |function| {
            let crossings = crossings.get_or_insert_with(none);
            let mut coefficients = [Lanes::from_f64(0.0); MAX_COEFFICIENTS];
            let mut count = 0;
            for (slot, coefficient) in coefficients.iter_mut().zip(function) {
                *slot = coefficient;
                count += 1;
            }
            for lane in lanes(asked) {
                let step = SearchedStep {
                    length: tau.0[lane],
                    epsilon: f64::EPSILON,
                    last_terms: || motion.last_terms_in(tau, |x| x.lane(lane)),
                    size: || motion.change_size_in(tau, |x| x.lane(lane)),
                };
                let of_lane = coefficients[..count].iter().map(|x| x.0[lane]);
                crossings[lane].add(of_lane, &step);
            }
        });
        crossings
    }

    /// Checks the times after each sign change of a switching function, in the lanes that are open. Lanes in which a
    /// check fails are closed.
    fn check_crossings<D>(
        &mut self,
        dynamics: &D,
        h: Lanes<L>,
        crossings: &[BranchCrossings; L],
        (verdicts, open): (&mut [Verdict; L], &mut [bool; L]),
    ) where
        D: Series<Lanes<L>, State = X> + ?Sized,
    {
        let mut behind = crossings.each_ref().map(BranchCrossings::with_times_behind);
        loop {
            let next: [_; L] = core::array::from_fn(|lane| {
                let behind = behind.get_mut(lane).filter(|_| open[lane]);
                behind.and_then(Iterator::next)
            });
            if next.iter().all(Option::is_none) {
                return;
            }
            for lane in lanes(open) {
                let inner = next[lane].filter(|(crossing, _)| {
                    dynamics.switching_function(crossing.function).is_inner
                });
                if let Some((crossing, _)) = inner {
                    verdicts[lane] = Verdict::Crosses(crossing);
                    open[lane] = false;
                }
            }
            let allowance = self.allowance(h.abs()).behind_crossings();
            for which in 0..2 {
                let parts = next.map(|next| next.map(|(_, times)| times[which]));
                let asked = core::array::from_fn(|lane| open[lane] && parts[lane].is_some());
                if !any(&asked) {
                    break;
                }
                let t = Lanes(self.time) + h * Lanes(parts.map(|part| part.unwrap_or(0.0)));
                let found = self.check_at(dynamics, (t, &self.at(&t.0)), &allowance, &asked);
                for lane in lanes(&asked) {
                    if let (Some(_), Some((crossing, _))) = (found[lane], next[lane]) {
                        verdicts[lane] = Verdict::Crosses(crossing);
                        open[lane] = false;
                    }
                }
            }
        }
    }

    /// Returns the allowed residuals in steps of lengths `h`.
    pub(super) fn allowance(&self, h: Lanes<L>) -> Allowance<Lanes<L>> {
        Allowance {
            h,
            order: number(Self::ORDER),
            tolerance: self.tolerance(h),
            roundings: Lanes::from_f64(RESIDUAL_ROUNDING),
        }
    }

    /// Checks one time in each lane. A difference is accepted if rounding or the tolerance explains it.
    pub(super) fn check_at<D>(
        &mut self,
        dynamics: &D,
        (t, reached): (Lanes<L>, &Reached<X, L>),
        allowance: &Allowance<Lanes<L>>,
        pending: &[bool; L],
    ) -> Beyond<L>
    where
        D: Series<Lanes<L>, State = X> + ?Sized,
    {
        let unit = Lanes::from_f64(1.0) / Lanes(self.unit);
        let point = Point {
            t,
            state: self.on_manifold(dynamics, t, &reached.state),
            slope: reached.slope.map(|component| component * unit),
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
        if any(&failing) {
            self.excuse(dynamics, (t, &point.state), &mut failing);
        }
        core::array::from_fn(|lane| {
            failing[lane].then(|| match non_finite(reached.state.value(), lane) {
                Some((index, _)) => index,
                None => first_beyond(&residual, &allowed, lane),
            })
        })
    }
}

/// Returns those of the `asked` lanes in which a component exceeds its allowed value or is not finite.
fn exceeds<X: LaneStates<L>, const L: usize>(
    residual: &X,
    allowed: &X,
    asked: &[bool; L],
) -> [bool; L] {
    let excess = residual.zip_map(allowed, |residual, allowed| {
        // Twice the excess, or 0, or NaN.
        let over = residual - allowed;
        over + over.abs()
    });
    let excess = excess.fold(Lanes::from_f64(0.0), |sum, excess| sum + excess);
    core::array::from_fn(|lane| asked[lane] && (excess.0[lane].is_nan() || excess.0[lane] > 0.0))
}

/// Returns the first component of a lane that exceeds its allowed value or is NaN.
#[cold]
fn first_beyond<X: LaneStates<L>, const L: usize>(residual: &X, allowed: &X, lane: usize) -> usize {
    let mut pairs = residual.components().zip(allowed.components());
    let found = pairs.position(|(residual, allowed)| {
        let excess = residual.lane(lane) - allowed.lane(lane);
        excess.is_nan() || excess > 0.0
    });
    found.unwrap_or(0)
}
