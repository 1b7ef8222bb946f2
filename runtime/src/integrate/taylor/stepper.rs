//! The steps of the Taylor series method.

mod checks;
mod correction;
mod following;
mod passage;
mod passing;
mod projection;

use super::interpolant::TaylorInterpolant;
use super::step_size::{Proposal, limiting_component, unit_near, weighted_norm, weights};
use super::uncertain_steps::UncertainSteps;
use super::{Series, Taylor};
use crate::integrate::dense_output::{DenseOutput, Interpolant};
use crate::integrate::dynamics::Dynamics;
use crate::integrate::error::IntegrationError;
use crate::integrate::projected::check_start;
use crate::integrate::step_polynomial::StepPolynomial;
use crate::integrate::stepper::{Advance, Statistics, Stepper, checked_derivative};
use crate::integrate::tolerance::Tolerance;
use crate::limits::taylor::{
    FIRST_UNIT, LANDING, MIN_STEP, UNIT_CHANGE, UNIT_CHANGES, VELOCITY_TIMES,
};
use crate::linalg::{ErrorTolerance, VectorSpace};
use crate::scalar::Scalar;
use checks::Verdict;

/// The stepper of a [`Taylor`] method.
///
/// The state is a compensated sum, so that its rounding errors do not grow over a long integration. Steps end at times
/// that are floating-point numbers, so that the time has no rounding error.
#[derive(Clone, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(
    feature = "serde",
    serde(bound(
        serialize = "X: serde::Serialize",
        deserialize = "X: Clone + serde::Deserialize<'de>"
    ))
)]
pub struct TaylorStepper<X, const HALF: usize> {
    method: Taylor<HALF>,
    /// Two polynomials: the one about the present time and state, and the one of the last step.
    polynomials: [TaylorInterpolant<X, HALF>; 2],
    /// Whether the second one is about the present time.
    exchanged: bool,
    /// The unit of time of the next series, near the size of the step, so that the coefficients neither overflow nor
    /// underflow.
    unit: f64,
    /// The step proposed by the polynomial about the present time, once its coefficients are computed.
    proposal: Option<Proposal>,
    /// The length of the last step; 0 before the first.
    length: f64,
    /// The steps that are checked within.
    uncertain: UncertainSteps,
    /// The time scale of the motion: the one at its start, or the longest step so far.
    time_scale: f64,
    /// Whether the other polynomial belongs to the last step.
    has_last: bool,
    /// The switching function whose discontinuity surface the motion cannot leave, if there is one.
    sliding: Option<usize>,
    /// The number of consecutive last steps that ended at discontinuity surfaces after no more than rounding errors of
    /// the time.
    short_passages: u32,
    statistics: Statistics,
}

impl<X, const HALF: usize> TaylorStepper<X, HALF> {
    /// Returns this stepper with other settings.
    pub(super) fn under(self, method: Taylor<HALF>) -> Self {
        Self { method, ..self }
    }

    pub(super) fn new<S: Scalar, D: Dynamics<S, State = X> + ?Sized>(
        method: Taylor<HALF>,
        dynamics: &D,
        t: f64,
        x: &X,
    ) -> Result<Self, IntegrationError>
    where
        X: VectorSpace<S>,
    {
        let derivative = checked_derivative(dynamics, t, x)?;
        let tolerance = method.tolerance::<S>();
        let time_scale = tolerance.time_scale(dynamics, x, &derivative);
        let time_scale = time_scale.unwrap_or_else(|| {
            let allowed = dynamics.allowed_error(x, &tolerance.over(S::one()));
            let weights = Tolerance::weights(&allowed);
            let largest = tolerance.relative.max(tolerance.absolute);
            1.0 / (weighted_norm(&derivative, &weights) * largest)
        });
        let time_scale = if time_scale.is_normal() {
            time_scale
        } else {
            1.0 / FIRST_UNIT
        };
        let of_motion = tolerance.over(S::from_f64(VELOCITY_TIMES * time_scale));
        check_start(dynamics, t, x, &of_motion)?;
        Ok(Self {
            method,
            polynomials: core::array::from_fn(|_| TaylorInterpolant::at_rest(t, x.clone())),
            exchanged: false,
            unit: unit_near(FIRST_UNIT * time_scale),
            proposal: None,
            length: 0.0,
            uncertain: UncertainSteps::NEW,
            time_scale,
            has_last: false,
            sliding: None,
            short_passages: 0,
            statistics: Statistics {
                evaluations: 1,
                ..Statistics::default()
            },
        })
    }

    /// Returns the polynomial about the present time.
    fn polynomial(&self) -> &TaylorInterpolant<X, HALF> {
        &self.polynomials[usize::from(self.exchanged)]
    }

    /// Returns the polynomial of the last step.
    pub(super) fn last(&self) -> Option<&TaylorInterpolant<X, HALF>> {
        self.has_last
            .then(|| &self.polynomials[usize::from(!self.exchanged)])
    }

    /// Computes the coefficients of one of the polynomials, about a reduced state, for a step of about this length. The
    /// unit of time is changed until they are finite; the error is a component that is not finite.
    fn expand<S: Scalar, D: Series<S, State = X> + ?Sized>(
        &mut self,
        dynamics: &D,
        (index, from): (usize, &X),
        mut unit: f64,
        length: f64,
    ) -> Result<Proposal, usize>
    where
        X: VectorSpace<S>,
    {
        let tolerance = self.tolerance(length);
        let polynomial = &mut self.polynomials[index];
        let t = S::from_f64(polynomial.time);
        let mut non_finite = None;
        let mut change = UNIT_CHANGE;
        for _ in 0..UNIT_CHANGES {
            polynomial.unit = unit;
            let coefficients = &mut polynomial.coefficients;
            dynamics.series((t, from), S::from_f64(unit), coefficients, None);
            self.statistics.evaluations += 1;
            let mut last = polynomial.coefficients.higher().iter().rev().take(2);
            non_finite = last.find_map(VectorSpace::first_non_finite);
            if non_finite.is_none() {
                let weights = weights(polynomial, dynamics, &tolerance, length.min(2.0 * unit));
                let proposal = Proposal::of(&polynomial.coefficients, &weights, &tolerance);
                // The step is 0 if a coefficient over its tolerance is not finite.
                if proposal.step > 0.0 {
                    return Ok(proposal);
                }
            }
            unit *= change;
            change *= change;
        }
        Err(non_finite.map_or(0, |(index, _)| index))
    }

    /// Returns the step proposed by the polynomial about the present time.
    fn proposal<S: Scalar, D: Series<S, State = X> + ?Sized>(
        &mut self,
        dynamics: &D,
    ) -> Result<Proposal, IntegrationError>
    where
        X: VectorSpace<S>,
    {
        if let Some(proposal) = self.proposal {
            return Ok(proposal);
        }
        let length = if self.length > 0.0 {
            self.length
        } else {
            FIRST_UNIT * self.time_scale
        };
        let from = self.polynomial().from.reduced(dynamics);
        let present = (usize::from(self.exchanged), &from);
        let component = match self.expand(dynamics, present, self.unit, length) {
            Ok(proposal) => {
                self.proposal = Some(proposal);
                return Ok(proposal);
            }
            Err(component) => component,
        };
        let time = self.polynomial().time;
        checked_derivative(dynamics, time, self.polynomial().from.value())?;
        Err(IntegrationError::NoTaylorSeries {
            time,
            component: dynamics.component_name(component),
        })
    }

    /// Completes a step of this length. The other polynomial, whose coefficients need not be known, becomes the present
    /// one.
    fn accept(&mut self, length: f64) {
        self.exchanged = !self.exchanged;
        self.time_scale = self.time_scale.max(length);
        self.has_last = true;
        self.statistics.steps += 1;
    }

    /// Returns the component that limits the step from the present time.
    fn limiting_component<S: Scalar, D: Dynamics<S, State = X> + ?Sized>(
        &self,
        dynamics: &D,
    ) -> usize
    where
        X: VectorSpace<S>,
    {
        let polynomial = self.polynomial();
        let tolerance = self.tolerance(self.length);
        let weights = weights(polynomial, dynamics, &tolerance, self.length);
        limiting_component(&polynomial.coefficients, &weights, Scalar::largest)
    }

    /// Returns the tolerances, for which an error of a velocity counts by the displacement that it causes in several
    /// time scales.
    fn tolerance<S: Scalar>(&self, length: f64) -> ErrorTolerance<S> {
        let time_scale = VELOCITY_TIMES * self.time_scale.max(length);
        self.method.tolerance::<S>().over(S::from_f64(time_scale))
    }
}

impl<S: Scalar, X: VectorSpace<S>, const HALF: usize> Stepper<S, X> for TaylorStepper<X, HALF> {
    const DENSE_OUTPUT: bool = true;

    fn time(&self) -> f64 {
        self.polynomial().time
    }

    fn state(&self) -> &X {
        self.polynomial().from.value()
    }

    fn previous_time(&self) -> f64 {
        self.last().unwrap_or(self.polynomial()).time
    }

    fn statistics(&self) -> Statistics {
        self.statistics
    }

    fn previous_state(&self) -> Option<&X> {
        Some(self.last()?.from.value())
    }

    fn visit_polynomial<V: StepPolynomial<S, X>>(&self, visitor: V) -> Option<V::Output> {
        let last = self.last()?;
        Some(visitor.visit(last.time, last.unit, &last.coefficients))
    }
}

impl<S: Scalar, X: VectorSpace<S>, D: Series<S, State = X> + ?Sized, const HALF: usize>
    Advance<S, D> for TaylorStepper<X, HALF>
{
    fn step(&mut self, dynamics: &D, target: f64) -> Result<(), IntegrationError> {
        let time = self.polynomial().time;
        let remaining = target - time;
        if !remaining.is_finite() {
            return Err(IntegrationError::NonFiniteTime { time: target });
        }
        if remaining == 0.0 {
            return Ok(());
        }
        if let Some(function) = self.sliding {
            return Err(self.sliding_error(dynamics, function));
        }
        self.has_last = false;
        let least = (MIN_STEP * f64::EPSILON * time.abs()).max(f64::MIN_POSITIVE);
        let longest = self.method.max_step.unwrap_or(f64::INFINITY);
        let mut proposal = self.proposal(dynamics)?;
        let unit = self.polynomial().unit;
        let mut step = (proposal.step * unit).min(longest);
        step = self.uncertain.limited(time, step.copysign(remaining));
        let passed = self.singular_configuration(dynamics, step.copysign(remaining));
        step = passed.lengthened(step).min(longest);
        let (mut is_first, mut rejected) = (true, None);
        loop {
            let lands = LANDING * step >= remaining.abs();
            if !lands && step <= least {
                return Err(self.too_small(dynamics, step, rejected));
            }
            let end = if lands {
                target
            } else {
                time + step.copysign(remaining)
            };
            let length = (end - time).abs();
            let asked = (!lands && rejected.is_none(), !lands && is_first);
            let beyond = match self.check(dynamics, end, (proposal, passed), asked)? {
                Verdict::Agrees(next) => {
                    if step.is_normal() {
                        self.unit = unit_near(step);
                    }
                    self.proposal = next;
                    self.length = length;
                    let proposed = proposal.step * unit;
                    let proposed = lands.then_some(proposed);
                    self.uncertain.accept(end, length, proposed);
                    self.short_passages = 0;
                    self.accept(length);
                    return Ok(());
                }
                Verdict::Crosses(crossing) => {
                    match self.pass(dynamics, (crossing, proposal), (end, target))? {
                        None => return Ok(()),
                        Some(component) => Err(component),
                    }
                }
                Verdict::Shorten(part) => Ok(part),
                Verdict::Differs(component) => Err(component),
            };
            self.statistics.rejected += 1;
            is_first = false;
            step = match beyond {
                Ok(part) => part * length,
                Err(component) => {
                    rejected = Some(component);
                    self.uncertain.reject(end, end - time);
                    let shortened = passed.shortened(length);
                    proposal.step = shortened / unit;
                    shortened
                }
            };
        }
    }

    fn interpolate(&mut self, _: &D, t: f64) -> X {
        match self.last() {
            Some(polynomial) => Interpolant::<S, X>::at(polynomial, t),
            None => self.polynomial().from.value().clone(),
        }
    }

    fn restart(&mut self, _: &D) {
        self.has_last = false;
        self.proposal = None;
        self.sliding = None;
        self.short_passages = 0;
    }

    fn restart_at(&mut self, dynamics: &D, t: f64, x: X) -> Result<(), IntegrationError> {
        let statistics = self.statistics;
        *self = Self::new(self.method, dynamics, t, &x)?;
        self.statistics = self.statistics.plus(statistics);
        Ok(())
    }
}

impl<S, X, D, const HALF: usize> DenseOutput<S, D> for TaylorStepper<X, HALF>
where
    S: Scalar,
    X: VectorSpace<S>,
    D: Series<S, State = X> + ?Sized,
{
    type Interpolant = TaylorInterpolant<X, HALF>;

    fn interpolant(&mut self, _: &D) -> Option<Self::Interpolant> {
        self.last().cloned()
    }
}
