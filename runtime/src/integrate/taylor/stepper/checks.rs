//! Whether a polynomial is the motion: at the end of a step, within it, and behind passages to other branches of the equations.

use super::TaylorStepper;
use crate::integrate::event::double_double;
use crate::integrate::taylor::Series;
use crate::integrate::taylor::branch_crossings::BranchCrossings;
use crate::integrate::taylor::coefficients::number;
use crate::integrate::taylor::residual::{Allowance, Point};
use crate::integrate::taylor::step_size::{Proposal, unit_near};
use crate::limits::taylor::{INNER_CHECKS, LONG_STEP};
use crate::linalg::VectorSpace;
use crate::scalar::Scalar;

impl<X, const HALF: usize> TaylorStepper<X, HALF> {
    /// Whether the polynomial is the motion until the time `end`: an error with the component at which its derivative
    /// is not that of the motion there, or at times within a step that is long or for which a polynomial of low degree
    /// is enough. The polynomial about `end`, whose first coefficient is the derivative there, becomes the other one;
    /// unless it is `needed`, its coefficients are left for later. What it says about the next step, if they are not.
    pub(super) fn check<S: Scalar, D: Series<S, State = X> + ?Sized>(
        &mut self,
        dynamics: &D,
        end: f64,
        proposal: Proposal,
        needed: bool,
    ) -> Result<Option<Proposal>, usize>
    where
        X: VectorSpace<S>,
    {
        let [present, next] = [self.exchanged, !self.exchanged].map(usize::from);
        let tau: S = self.polynomials[present].argument(end);
        let (state, slope) = self.polynomials[present].state_and_derivative(tau);
        if let Some((index, _)) = state.value().first_non_finite() {
            return Err(index);
        }
        let point = Point {
            t: S::from_f64(end),
            state: state.reduced(dynamics),
            slope,
        };
        let h = (end - self.polynomials[present].time).abs();
        self.polynomials[next].time = end;
        self.polynomials[next].from = state;
        let mut next_proposal = None;
        if needed && h.is_normal() {
            let about_end = (next, &point.state);
            let proposal = self.expand(dynamics, about_end, unit_near(h), h);
            next_proposal = proposal.ok();
        }
        let derivative = if next_proposal.is_some() {
            self.polynomials[next].first_derivative()
        } else {
            self.statistics.evaluations += 1;
            dynamics.derivative(point.t, &point.state)
        };
        let allowance = self.allowance(h);
        allowance.check(dynamics, &point, &derivative)?;
        let largest = tau.abs().largest();
        if h > LONG_STEP * self.length || proposal.is_of_low_degree(largest, HALF) {
            self.check_within(dynamics, end, &allowance)?;
        }
        self.check_branches(dynamics, end, largest.copysign(tau.smallest()), &allowance)?;
        Ok(next_proposal)
    }

    /// Whether the polynomial about the present time, if its coefficients are known, has the derivative of these dynamics there.
    pub(in crate::integrate::taylor) fn is_of<S: Scalar, D: Series<S, State = X> + ?Sized>(
        &self,
        dynamics: &D,
    ) -> bool
    where
        X: VectorSpace<S>,
    {
        let polynomial = self.polynomial();
        let point = Point {
            t: S::from_f64(polynomial.time),
            state: polynomial.from.reduced(dynamics),
            slope: polynomial.first_derivative(),
        };
        let derivative = dynamics.derivative(point.t, &point.state);
        let allowance = self.allowance(self.length);
        self.proposal.is_none() || allowance.check(dynamics, &point, &derivative).is_ok()
    }

    fn allowance<S: Scalar>(&self, h: f64) -> Allowance<S> {
        Allowance {
            h: S::from_f64(h),
            order: number(2 * HALF),
            tolerance: self.tolerance(h),
        }
    }

    /// The check at times within a step.
    fn check_within<S: Scalar, D: Series<S, State = X> + ?Sized>(
        &mut self,
        dynamics: &D,
        end: f64,
        allowance: &Allowance<S>,
    ) -> Result<(), usize>
    where
        X: VectorSpace<S>,
    {
        for i in 1..=INNER_CHECKS {
            let part = f64::from(i) / f64::from(INNER_CHECKS + 1);
            self.check_at(dynamics, (end, part), allowance)?;
        }
        Ok(())
    }

    /// The check at a part of a step.
    fn check_at<S: Scalar, D: Series<S, State = X> + ?Sized>(
        &mut self,
        dynamics: &D,
        (end, part): (f64, f64),
        allowance: &Allowance<S>,
    ) -> Result<(), usize>
    where
        X: VectorSpace<S>,
    {
        let polynomial = &self.polynomials[usize::from(self.exchanged)];
        let t = polynomial.time + (end - polynomial.time) * part;
        let (state, slope) = polynomial.state_and_derivative(polynomial.argument(t));
        let point = Point {
            t: S::from_f64(t),
            state: state.reduced(dynamics),
            slope,
        };
        self.statistics.evaluations += 1;
        let derivative = dynamics.derivative(point.t, &point.state);
        allowance.check(dynamics, &point, &derivative)
    }

    /// The check behind each time within a step at which the motion passes to another branch of the equations. A step with
    /// too many of them is to be shortened: an error with the first component.
    fn check_branches<S: Scalar, D: Series<S, State = X> + ?Sized>(
        &mut self,
        dynamics: &D,
        end: f64,
        length: f64,
        allowance: &Allowance<S>,
    ) -> Result<(), usize>
    where
        X: VectorSpace<S>,
    {
        let polynomial = &self.polynomials[usize::from(self.exchanged)];
        let (t, unit) = (S::from_f64(polynomial.time), S::from_f64(polynomial.unit));
        let mut crossings = BranchCrossings::NONE;
        dynamics.branches(
            t,
            &polynomial.from.reduced(dynamics),
            unit,
            &polynomial.coefficients,
            &mut |argument| {
                crossings.add(argument.map(double_double), length, S::machine_epsilon());
            },
        );
        if crossings.overflows() {
            return Err(0);
        }
        for part in crossings.times_between() {
            self.check_at(dynamics, (end, part), allowance)?;
        }
        Ok(())
    }
}
