//! Checks that the motions agree with their series at the end of a step and after passages to other branches of the
//! equations.

use super::attempt::{Attempt, Expansion};
use super::verdicts::{Beyond, Verdict, Verdicts};
use super::within::SingleMotions;
use super::{Reached, TaylorLanes, any, both, lanes, non_finite, number};
use crate::integrate::taylor::Series;
use crate::integrate::taylor::branch_crossings::{BranchCrossings, SearchedStep};
use crate::integrate::taylor::correction::correction;
use crate::integrate::taylor::residual::{Allowance, Point};
use crate::limits::events::MAX_COEFFICIENTS;
use crate::limits::taylor::{RESIDUAL_ROUNDING, RESOLUTION};
use crate::linalg::LaneStates;
use crate::scalar::{Lanes, Scalar};

impl<X: LaneStates<L>, const L: usize, const HALF: usize> TaylorLanes<X, L, HALF> {
    /// Checks the steps in the pending lanes, as [`TaylorStepper`](crate::TaylorStepper) does. Returns `None` if all of
    /// them agree with the motions.
    pub(super) fn check<D, M>(
        &mut self,
        (dynamics, motions): (&D, &M),
        attempt: &mut Attempt<X, L>,
        (expansion, reached): (&Expansion<X, L>, &Reached<X, L>),
    ) -> Option<[Verdict; L]>
    where
        D: Series<Lanes<L>, State = X> + ?Sized,
        M: SingleMotions<X, L>,
    {
        let Attempt {
            targets, pending, ..
        } = *attempt;
        let h = Lanes(targets) - Lanes(self.time);
        let mut verdicts = Verdicts::of(&pending);
        verdicts.need_finite(reached.state.value());
        let asked = (reached.tau, &verdicts.open);
        let crossings = self.crossings(dynamics, (&expansion.from, h), asked);
        if let Some(crossings) = &crossings {
            self.check_crossings(dynamics, h, crossings, &mut verdicts);
        }
        if !any(&verdicts.open) {
            return Some(verdicts.of_lanes);
        }
        let mut allowance = self.allowance(h.abs());
        let end = self.point(dynamics, (Lanes(targets), reached));
        if let Some(passed) = &expansion.passed {
            let growth = |lane: usize| passed[lane].growth(h.0[lane].abs(), Self::ORDER);
            allowance.roundings *= Lanes::from_fn(growth);
            self.reject_overlooked(dynamics, attempt, (passed, &end.state), &mut verdicts);
        }
        let derivative = dynamics.derivative(end.t, &end.state);
        if self.method.corrects::<Lanes<L>>() && crossings.is_none() {
            let slopes = [&end.slope, &derivative];
            attempt.correction = Some(correction(h, slopes, Self::ORDER));
        }
        let point = (&end, &derivative, reached.state.value());
        if let Some(found) = self.check_point(dynamics, point, &allowance, &verdicts.open) {
            verdicts.put_ends(&found, crossings.as_ref());
        }
        let mut inner = self.is_uncertain_within(h, &expansion.proposals, &verdicts.open);
        if let Some(crossings) = &crossings {
            for lane in lanes(&verdicts.open) {
                inner[lane] |= crossings[lane].has_noise;
            }
        }
        if any(&inner) {
            let found = self.check_within((dynamics, motions), (h, &allowance), inner);
            verdicts.put_differences(&found);
        }
        (verdicts.open != pending).then_some(verdicts.of_lanes)
    }

    /// Returns the sign changes of switching functions in the steps of lengths `h` of the lanes that are asked for; `None`
    /// if there are no switching functions.
    fn crossings<D>(
        &self,
        dynamics: &D,
        (from, h): (&X, Lanes<L>),
        (tau, asked): (Lanes<L>, &[bool; L]),
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
        dynamics.branches(t, from, unit, motion, &mut |function| {
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

    /// Checks that the series of the switching functions converge, and the times after each of their sign changes, in the
    /// lanes without a verdict.
    #[inline(never)]
    fn check_crossings<D>(
        &mut self,
        dynamics: &D,
        h: Lanes<L>,
        crossings: &[BranchCrossings; L],
        verdicts: &mut Verdicts<L>,
    ) where
        D: Series<Lanes<L>, State = X> + ?Sized,
    {
        for lane in lanes(&verdicts.open) {
            if crossings[lane].converging < 1.0 {
                verdicts.put(lane, Verdict::Shorten(crossings[lane].converging));
            }
        }
        let mut behind = crossings.each_ref().map(BranchCrossings::with_times_behind);
        loop {
            let next: [_; L] = core::array::from_fn(|lane| {
                let behind = behind.get_mut(lane).filter(|_| verdicts.open[lane]);
                behind.and_then(Iterator::next)
            });
            if next.iter().all(Option::is_none) {
                return;
            }
            for lane in lanes(&verdicts.open) {
                let inner = next[lane].filter(|(crossing, _)| {
                    dynamics.switching_function(crossing.function).is_inner
                });
                if let Some((crossing, _)) = inner {
                    verdicts.put(lane, Verdict::Crosses(crossing));
                }
            }
            let allowance = self.allowance(h.abs()).behind_crossings();
            for which in 0..2 {
                let parts = next.map(|next| next.map(|(_, times)| times[which]));
                let asked =
                    core::array::from_fn(|lane| verdicts.open[lane] && parts[lane].is_some());
                if !any(&asked) {
                    break;
                }
                let t = Lanes(self.time) + h * Lanes(parts.map(|part| part.unwrap_or(0.0)));
                let reached = self.at(&t.0);
                let Some(found) = self.check_at(dynamics, (t, &reached), &allowance, &asked) else {
                    continue;
                };
                for lane in lanes(&asked) {
                    if let (Some(_), Some((crossing, _))) = (found[lane], next[lane]) {
                        verdicts.put(lane, Verdict::Crosses(crossing));
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

    /// Checks one time in each lane, as [`check_point`](Self::check_point) does.
    pub(super) fn check_at<D>(
        &mut self,
        dynamics: &D,
        (t, reached): (Lanes<L>, &Reached<X, L>),
        allowance: &Allowance<Lanes<L>>,
        asked: &[bool; L],
    ) -> Option<Beyond<L>>
    where
        D: Series<Lanes<L>, State = X> + ?Sized,
    {
        let point = self.point(dynamics, (t, reached));
        let derivative = dynamics.derivative(t, &point.state);
        let point = (&point, &derivative, reached.state.value());
        self.check_point(dynamics, point, allowance, asked)
    }

    /// Returns the reduced values of the polynomials at a time in each lane, and their derivatives.
    #[inline]
    fn point<D>(&self, dynamics: &D, (t, reached): (Lanes<L>, &Reached<X, L>)) -> Point<Lanes<L>, X>
    where
        D: Series<Lanes<L>, State = X> + ?Sized,
    {
        let rate = Lanes::from_f64(1.0) / Lanes(self.unit);
        Point {
            t,
            state: self.on_manifold(dynamics, t, &reached.state),
            slope: reached.slope.map(|component| component * rate),
        }
    }

    /// Compares the derivatives of the polynomials with the derivatives of the motions at a point in each lane, whose `state`
    /// before its reduction is given, too. A difference is accepted if rounding or the tolerance explains it. Returns `None` if the
    /// polynomials agree with the motions in all lanes that are asked for.
    fn check_point<D>(
        &mut self,
        dynamics: &D,
        (point, derivative, state): (&Point<Lanes<L>, X>, &X, &X),
        allowance: &Allowance<Lanes<L>>,
        asked: &[bool; L],
    ) -> Option<Beyond<L>>
    where
        D: Series<Lanes<L>, State = X> + ?Sized,
    {
        let [residual, allowed] = allowance.residual(dynamics, point, derivative);
        for (statistics, asked) in self.statistics.iter_mut().zip(asked) {
            statistics.evaluations += u64::from(*asked);
        }
        let failing = exceeds(&residual, &allowed, asked);
        if !any(&failing) {
            return None;
        }
        let beyond = Difference {
            point,
            derivative,
            residual,
            allowed,
        };
        let beyond = self.explain(dynamics, beyond, allowance, failing)?;
        Some(core::array::from_fn(|lane| {
            let non_finite = non_finite(state, lane).map(|(index, _)| index);
            Some(non_finite.unwrap_or(beyond[lane]?))
        }))
    }

    /// Returns the components of the failing lanes in which neither the condition of the derivative nor a singular
    /// configuration explains the difference.
    #[cold]
    fn explain<D>(
        &mut self,
        dynamics: &D,
        difference: Difference<'_, X, L>,
        allowance: &Allowance<Lanes<L>>,
        mut failing: [bool; L],
    ) -> Option<Beyond<L>>
    where
        D: Series<Lanes<L>, State = X> + ?Sized,
    {
        let Difference {
            point,
            derivative,
            residual,
            mut allowed,
        } = difference;
        allowance.allow_condition(dynamics, point, derivative, &mut allowed);
        for lane in lanes(&failing) {
            self.statistics[lane].evaluations += 2;
        }
        failing = exceeds(&residual, &allowed, &failing);
        if any(&failing) {
            self.excuse(dynamics, (point.t, &point.state), &mut failing);
        }
        let component = |lane: usize| first_beyond(&residual, &allowed, lane);
        any(&failing).then(|| core::array::from_fn(|lane| failing[lane].then(|| component(lane))))
    }
}

/// A difference between the derivatives of the polynomials and the motions that the tolerance does not explain.
struct Difference<'a, X, const L: usize> {
    point: &'a Point<Lanes<L>, X>,
    derivative: &'a X,
    residual: X,
    allowed: X,
}

/// Returns those of the `asked` lanes in which a component exceeds its allowed value or is not finite.
#[inline]
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
    // In most cases there is none, which the sum of all lanes shows.
    if excess.0.iter().sum::<f64>() <= 0.0 {
        return [false; L];
    }
    let exceeds = excess.0.map(|excess| excess.is_nan() || excess > 0.0);
    both(&exceeds, asked)
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
