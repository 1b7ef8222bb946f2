//! The polynomials of motions in lanes, and the step sizes that they propose.

use super::attempt::Proposals;
use super::{TaylorLanes, any, lanes, non_finite, number};
use crate::integrate::binary_logarithm::{are_normal, exp2_of_each, log2, log2_of_each};
use crate::integrate::error::IntegrationError;
use crate::integrate::projected::allow_least;
use crate::integrate::taylor::step_size::{decrease, reached};
use crate::integrate::taylor::{Series, SeriesMemory};
use crate::integrate::tolerance::{Tolerance, largest_ratios};
use crate::limits::taylor::{FIRST_UNIT, UNIT_CHANGE, UNIT_CHANGES, VELOCITY_TIMES};
use crate::linalg::{ErrorTolerance, LaneStates};
use crate::scalar::{Lanes, Scalar};

impl<X: LaneStates<L>, const L: usize, const HALF: usize> TaylorLanes<X, L, HALF> {
    /// Computes the polynomials about the present times, in units in which their coefficients are finite, and the step
    /// sizes that they propose.
    #[inline]
    pub(super) fn expand<D>(
        &mut self,
        (dynamics, mut memory): (&D, Option<&mut SeriesMemory>),
        from: &X,
        moving: &mut [bool; L],
    ) -> Proposals<L>
    where
        D: Series<Lanes<L>, State = X> + ?Sized,
    {
        let mut waiting = *moving;
        let mut proposals = Proposals {
            step: [0.0; L],
            middle: Lanes([0.0; L]),
        };
        let mut change = UNIT_CHANGE;
        for _ in 0..UNIT_CHANGES {
            let (t, unit) = (Lanes(self.time), Lanes(self.unit));
            let memory = memory.as_deref_mut();
            dynamics.series((t, from), unit, &mut self.coefficients, memory);
            let weights = Tolerance::weights(&self.allowed(dynamics));
            let proposed = self.proposed(&weights);
            proposals.middle = self.middle(&weights);
            for (statistics, waiting) in self.statistics.iter_mut().zip(waiting) {
                statistics.evaluations += u64::from(waiting);
            }
            // The proposal is 0 if a coefficient over its tolerance is not finite.
            let found: [bool; L] =
                core::array::from_fn(|lane| waiting[lane] && proposed[lane] > 0.0);
            proposals.step = core::array::from_fn(|lane| {
                if found[lane] {
                    proposed[lane] * self.unit[lane]
                } else {
                    proposals.step[lane]
                }
            });
            waiting = core::array::from_fn(|lane| waiting[lane] && !found[lane]);
            if !any(&waiting) {
                return proposals;
            }
            for lane in lanes(&waiting) {
                self.unit[lane] *= change;
            }
            change *= change;
        }
        for lane in lanes(&waiting) {
            moving[lane] = false;
            self.no_series(dynamics, lane);
        }
        proposals
    }

    /// Records the error for a lane whose series is not finite in any unit of time.
    #[cold]
    fn no_series<D>(&mut self, dynamics: &D, lane: usize)
    where
        D: Series<Lanes<L>, State = X> + ?Sized,
    {
        let derivative = self.derivative(dynamics);
        let error = self.setting_error(dynamics, lane, &derivative);
        let error = error.unwrap_or_else(|| {
            let mut last = self.coefficients.higher().iter().rev().take(2);
            let found = last.find_map(|coefficient| non_finite(coefficient, lane));
            IntegrationError::NoTaylorSeries {
                time: self.time[lane],
                component: dynamics.component_name(found.map_or(0, |(index, _)| index)),
            }
        });
        self.unit[lane] = 1.0;
        self.fail(lane, error);
    }

    /// Returns the steps at which the last two terms meet the tolerance, in units of time; 0 if the terms are not
    /// finite. The last one is expected to be smaller than the one before. If they are zero, the terms before them are used, as in [`TaylorStepper`](super::TaylorStepper).
    #[inline]
    fn proposed(&self, weights: &X) -> [f64; L] {
        if let [.., before, last] = self.coefficients.higher()
            && HALF > 1
        {
            let before = largest_ratios(before, weights).0;
            let last = largest_ratios(last, weights).0;
            if are_normal(&before) & are_normal(&last) {
                let (before, last) = (log2_of_each(before), log2_of_each(last));
                let decrease = self.decrease();
                let order = number(Self::ORDER);
                return exp2_of_each(core::array::from_fn(|lane| {
                    ((decrease - last[lane]) / order).min(-before[lane] / (order - 1.0))
                }));
            }
        }
        self.proposed_by_some(weights)
    }

    /// [`proposed`](Self::proposed) if not all of the last two terms are positive and finite.
    #[cold]
    fn proposed_by_some(&self, weights: &X) -> [f64; L] {
        let higher = self.coefficients.higher();
        let decrease = self.decrease();
        let mut logarithm = [f64::INFINITY; L];
        for (position, coefficient) in higher.iter().rev().enumerate().take(HALF) {
            let ratios = largest_ratios(coefficient, weights).0;
            let order = number(Self::ORDER - position);
            let least = if position == 0 { decrease } else { 0.0 };
            let mut found = true;
            for (logarithm, ratio) in logarithm.iter_mut().zip(ratios) {
                let zero_until_now = position < 2 || *logarithm >= f64::INFINITY;
                if ratio.is_nan() {
                    *logarithm = f64::NEG_INFINITY;
                } else if ratio > 0.0 && zero_until_now {
                    *logarithm = logarithm.min((least - log2(ratio)) / order);
                }
                found &= *logarithm < f64::INFINITY;
            }
            if position > 0 && found {
                break;
            }
        }
        exp2_of_each(logarithm)
    }

    /// Returns the binary logarithm of the expected ratio of the last term to the one before.
    #[inline]
    fn decrease(&self) -> f64 {
        decrease(self.method.tolerance::<Lanes<L>>(), Self::ORDER)
    }

    /// Returns the larger of the two terms of about half the order, over their tolerances.
    #[inline]
    fn middle(&self, weights: &X) -> Lanes<L> {
        let mut most = Lanes([0.0; L]);
        for term in self.coefficients.higher().iter().take(HALF).rev().take(2) {
            most = Scalar::max(most, largest_ratios(term, weights));
        }
        most
    }

    /// Returns the allowed errors for the sizes that the components reach within a step like the last one.
    pub(super) fn allowed<D>(&self, dynamics: &D) -> X
    where
        D: Series<Lanes<L>, State = X> + ?Sized,
    {
        let unit = Lanes(self.unit);
        let first = Lanes(self.time_scale) * Lanes::from_f64(FIRST_UNIT);
        let next = Scalar::min(Lanes(self.length), unit + unit);
        let length = Lanes::from_fn(|lane| {
            if self.length[lane] > 0.0 {
                next.0[lane]
            } else {
                first.0[lane]
            }
        });
        let tau = length / unit;
        let reached = reached(self.state.value(), &self.coefficients, tau);
        let mut allowed = dynamics.allowed_error(&reached, &self.tolerance(Lanes(self.length)));
        let here = (Lanes(self.time), self.state.value());
        allow_least(dynamics, here, &reached, &mut allowed);
        allowed
    }

    /// Returns the tolerances of steps of these lengths, for which an error of a velocity counts by the displacement
    /// that it causes in several time scales.
    pub(super) fn tolerance(&self, length: Lanes<L>) -> ErrorTolerance<Lanes<L>> {
        let time_scale = Scalar::max(Lanes(self.time_scale), length);
        let tolerance = self.method.tolerance::<Lanes<L>>();
        tolerance.over(time_scale * Lanes::from_f64(VELOCITY_TIMES))
    }
}
