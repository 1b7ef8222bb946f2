//! Checks that a polynomial is the motion: at the end of a step, within it, and after passages to other branches of the
//! equations.

use super::TaylorStepper;
use crate::integrate::error::IntegrationError;
use crate::integrate::projected::reduced_on_manifold;
use crate::integrate::taylor::Series;
use crate::integrate::taylor::branch_crossings::{BranchCrossings, Crossing, SearchedStep};
use crate::integrate::taylor::coefficients::number;
use crate::integrate::taylor::residual::{Allowance, Point};
use crate::integrate::taylor::singular_configuration::SingularConfiguration;
use crate::integrate::taylor::step_size::{Proposal, unit_near};
use crate::limits::taylor::passing::SHORT;
use crate::limits::taylor::{INNER_CHECKS, RESIDUAL_ROUNDING, RESOLUTION};
use crate::linalg::VectorSpace;
use crate::scalar::Scalar;

/// The result of the check that the polynomial is the motion within a step.
pub(super) enum Verdict {
    /// The polynomial agrees, with the next step proposed by the polynomial about the end, if that is known.
    Agrees(Option<Proposal>),
    /// The polynomial differs from the motion in this component.
    Differs(usize),
    /// The step is to be tried with this fraction of its length: the series of all switching functions converge in it, or the
    /// step ends at a singular configuration that was not found.
    Shorten(f64),
    /// The polynomial differs from the motion after a sign change of a switching function.
    Crosses(Crossing),
}

impl<X, const HALF: usize> TaylorStepper<X, HALF> {
    /// Checks that the polynomial is the motion until the time `end`.
    ///
    /// Its derivative is compared with the derivative of the motion at `end`, after each sign change of a switching
    /// function, and, if the step is [uncertain](Self::is_uncertain_within), at times within the step. The
    /// polynomial about `end`, whose first coefficient is the derivative there, becomes the other one. Its coefficients
    /// are not computed yet if they are not `needed`, or if `end` is corrected. A step that `may_halve` must not end at a
    /// singular configuration that was not found.
    ///
    /// # Errors
    ///
    /// If the end of the step cannot be projected onto the manifold of the dynamics.
    pub(super) fn check<S: Scalar, D: Series<S, State = X> + ?Sized>(
        &mut self,
        dynamics: &D,
        end: f64,
        (proposal, passed): (Proposal, SingularConfiguration),
        (needed, may_halve): (bool, bool),
    ) -> Result<Verdict, IntegrationError>
    where
        X: VectorSpace<S>,
    {
        let [present, next] = [self.exchanged, !self.exchanged].map(usize::from);
        let tau: S = self.polynomials[present].argument(end);
        let (state, slope) = self.polynomials[present].state_and_derivative(tau);
        if let Some((index, _)) = state.value().first_non_finite() {
            return Ok(Verdict::Differs(index));
        }
        let h = (end - self.polynomials[present].time).abs();
        let mut allowance = self.allowance(h);
        allowance.roundings *= S::from_f64(passed.growth(h, 2 * HALF));
        let (crossings, has_branches) = self.crossings(dynamics, end);
        if crossings.converging < 1.0 {
            return Ok(Verdict::Shorten(crossings.converging));
        }
        if let Some(crossing) = self.first_crossing(dynamics, end, &crossings) {
            return Ok(Verdict::Crosses(crossing));
        }
        let t = S::from_f64(end);
        let corrects = self.method.corrects::<S>() && !has_branches;
        let mut projection = if corrects {
            None
        } else {
            dynamics.project(t, state.value())
        };
        let point = Point {
            t,
            state: reduced_on_manifold(dynamics, &state, projection.as_ref()),
            slope,
        };
        if may_halve && self.overlooks(dynamics, (t, &point.state), (passed, h)) {
            return Ok(Verdict::Shorten(SHORT));
        }
        self.polynomials[next].time = end;
        self.polynomials[next].from = state;
        let mut next_proposal = None;
        if needed && !corrects && h.is_normal() {
            let about_end = (next, &point.state);
            next_proposal = self.expand(dynamics, about_end, unit_near(h), h).ok();
        }
        let derivative = if next_proposal.is_some() {
            self.polynomials[next].first_derivative()
        } else {
            self.statistics.evaluations += 1;
            dynamics.derivative(point.t, &point.state)
        };
        if let Err(component) = allowance.check(dynamics, &point, &derivative)
            && !self.is_passing(dynamics, point.t, &point.state)
        {
            return Ok(match crossings.at_end {
                Some(function) => Verdict::Crosses(Crossing { at: 1.0, function }),
                None => Verdict::Differs(component),
            });
        }
        if (crossings.has_noise || self.is_uncertain_within(proposal, end, tau))
            && let Err(component) = self.check_within(dynamics, end, &allowance)
        {
            return Ok(Verdict::Differs(component));
        }
        if corrects {
            self.correct_end(&point, &derivative, tau);
            projection = dynamics.project(t, self.polynomials[next].from.value());
        }
        if let Some(projection) = projection {
            let projected = self.project_end(dynamics, &projection, passed.limits_corrections());
            if corrects && projected.is_err() {
                // The polynomial of the step has been changed.
                self.proposal = None;
            }
            projected?;
        }
        Ok(Verdict::Agrees(next_proposal))
    }

    /// Returns the first sign change of a switching function after which the polynomial differs from the motion.
    fn first_crossing<S: Scalar, D: Series<S, State = X> + ?Sized>(
        &mut self,
        dynamics: &D,
        end: f64,
        crossings: &BranchCrossings,
    ) -> Option<Crossing>
    where
        X: VectorSpace<S>,
    {
        let h = (end - self.polynomial().time).abs();
        for (crossing, times) in crossings.with_times_behind() {
            if dynamics.switching_function(crossing.function).is_inner {
                return Some(crossing);
            }
            let allowance = self.allowance(h).behind_crossings();
            for part in times {
                if self.check_at(dynamics, (end, part), &allowance).is_err() {
                    return Some(crossing);
                }
            }
        }
        None
    }

    /// Whether a step until the time `end` is so long, or a polynomial of such a low degree is enough for it, that the
    /// series may miss changes within it, or it lies before the end of a rejected step.
    pub(super) fn is_uncertain_within<S: Scalar>(
        &self,
        proposal: Proposal,
        end: f64,
        tau: S,
    ) -> bool {
        let begin = self.polynomial().time;
        self.uncertain.contain(begin, end - begin)
            || proposal.is_of_low_degree(tau.abs().largest(), HALF)
    }

    /// Whether the polynomial about the present time has the derivative of these dynamics there, or its coefficients
    /// are not known.
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

    pub(super) fn allowance<S: Scalar>(&self, h: f64) -> Allowance<S> {
        Allowance {
            h: S::from_f64(h),
            order: number(2 * HALF),
            tolerance: self.tolerance(h),
            roundings: S::from_f64(RESIDUAL_ROUNDING),
        }
    }

    /// Checks times within a step.
    pub(super) fn check_within<S: Scalar, D: Series<S, State = X> + ?Sized>(
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

    /// Checks one time, at a fraction of a step.
    pub(super) fn check_at<S: Scalar, D: Series<S, State = X> + ?Sized>(
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
        let t = S::from_f64(t);
        let projection = if self.method.passes_singularities {
            dynamics.project(t, state.value())
        } else {
            None
        };
        let point = Point {
            t,
            state: reduced_on_manifold(dynamics, &state, projection.as_ref()),
            slope,
        };
        self.statistics.evaluations += 1;
        let derivative = dynamics.derivative(point.t, &point.state);
        let checked = allowance.check(dynamics, &point, &derivative);
        if checked.is_err() && self.is_passing(dynamics, point.t, &point.state) {
            return Ok(());
        }
        checked
    }

    /// Returns the sign changes of switching functions in a step, and whether there are such functions.
    fn crossings<S: Scalar, D: Series<S, State = X> + ?Sized>(
        &self,
        dynamics: &D,
        end: f64,
    ) -> (BranchCrossings, bool)
    where
        X: VectorSpace<S>,
    {
        let polynomial = self.polynomial();
        let (t, unit) = (S::from_f64(polynomial.time), S::from_f64(polynomial.unit));
        let epsilon = S::machine_epsilon();
        let h = (end - polynomial.time).abs();
        let resolution = RESOLUTION * epsilon * (polynomial.time.abs() + h) / h;
        let (mut crossings, mut has_branches) = (BranchCrossings::none(resolution), false);
        let tau: S = polynomial.argument(end);
        let step = SearchedStep {
            length: tau.largest(),
            epsilon,
            last_terms: || polynomial.coefficients.last_terms_in(tau, S::largest),
            size: || polynomial.coefficients.change_size_in(tau, S::largest),
        };
        let from = polynomial.from.reduced(dynamics);
        let motion = &polynomial.coefficients;
        dynamics.branches(t, &from, unit, motion, &mut |function| {
            has_branches = true;
            crossings.add(function.map(Scalar::largest), &step);
        });
        (crossings, has_branches)
    }
}
