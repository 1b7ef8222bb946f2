//! The steps of DOP853.

use super::coefficients::{MATRIX, NODES};
use super::dense_output::{DensePolynomial, Dop853Interpolant};
use super::derivative_parts::Attempted;
use super::stage_sums::StageSums;
use super::step_control::{self, Attempt, StepControl, initial_step, too_small};
use super::{ALL_STAGES, Dop853, STAGES};
use crate::integrate::compensated::{Clock, Compensated};
use crate::integrate::dense_output::DenseOutput;
use crate::integrate::dynamics::Dynamics;
use crate::integrate::error::IntegrationError;
use crate::integrate::passing::Clearance;
use crate::integrate::projected::{Projected, check_start};
use crate::integrate::runge_kutta::stage_state;
use crate::integrate::stepper::{
    Advance, Statistics, Stepper, checked_derivative, checked_state, derivative_apart, remaining,
};
use crate::limits::dormand_prince::{self as limits, MIN_TIME_SCALE};
use crate::linalg::VectorSpace;
use crate::scalar::Scalar;

/// The stepper of [`Dop853`].
///
/// Time and state are compensated sums, so that their rounding errors do not grow over a long integration.
#[derive(Clone, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Dop853Stepper<X> {
    pub(super) method: Dop853,
    pub(super) clock: Clock,
    pub(super) state: Compensated<X>,
    /// The size of the next step; `None` until the first is chosen.
    control: Option<StepControl>,
    /// The derivatives kᵢ of the last step; the one at `STAGES` is the derivative at the present state.
    pub(super) stages: [X; ALL_STAGES],
    last: Option<LastStep<X>>,
    statistics: Statistics,
}

/// The last step, as dense output needs it.
#[derive(Clone, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
struct LastStep<X> {
    clock: Clock,
    x: Compensated<X>,
    h: f64,
    dense: Option<DensePolynomial<X>>,
}

impl<X> Dop853Stepper<X> {
    /// Returns this stepper with other settings.
    pub(super) fn under(self, method: Dop853) -> Self {
        Self { method, ..self }
    }

    /// Whether the stored derivative at the present time agrees with these dynamics.
    pub(super) fn is_of<S: Scalar, D: Dynamics<S, State = X> + ?Sized>(&self, dynamics: &D) -> bool
    where
        X: VectorSpace<S>,
    {
        let t = S::from_f64(self.clock.time());
        let derivative = derivative_apart(dynamics, t, &self.state.reduced(dynamics));
        let mut pairs = derivative
            .components()
            .zip(self.stages[STAGES].components());
        pairs.all(|(x, known)| (x - known).abs().largest() <= 0.0)
    }

    pub(super) fn new<S: Scalar, D: Dynamics<S, State = X> + ?Sized>(
        method: Dop853,
        dynamics: &D,
        t: f64,
        x: X,
    ) -> Result<Self, IntegrationError>
    where
        X: VectorSpace<S>,
    {
        let derivative = checked_derivative(dynamics, t, &x)?;
        let time_scale = method.tolerance.time_scale(dynamics, &x, &derivative);
        let tolerance = (method.tolerance).over(S::from_f64(time_scale.unwrap_or(1.0)));
        check_start(dynamics, t, &x, &tolerance)?;
        Ok(Self {
            method,
            clock: Clock::new(t),
            state: Compensated::new(x),
            control: None,
            stages: core::array::from_fn(|_| derivative.clone()),
            last: None,
            statistics: Statistics {
                evaluations: 1,
                ..Statistics::default()
            },
        })
    }

    /// Evaluates all stages but the first of a step h from x, which is reduced, and adds them to the sums.
    #[inline]
    fn evaluate<S: Scalar, D: Dynamics<S, State = X> + ?Sized>(
        &mut self,
        dynamics: &D,
        x: &X,
        h: f64,
        sums: &mut StageSums<X>,
    ) where
        X: VectorSpace<S>,
    {
        for (i, node) in (1..STAGES).zip(&NODES[1..STAGES]) {
            let mut at = x.clone();
            at.add_scaled(S::from_f64(h), sums.slope(i));
            let t = S::from_f64(self.clock.after(node * h));
            self.stages[i] = dynamics.derivative(t, &at);
            sums.add(i, &self.stages[i]);
        }
        self.statistics.evaluations += STAGES as u64 - 1;
    }

    /// Computes a step of size `h` and its error without changing the state.
    pub(super) fn attempt<S: Scalar, D: Dynamics<S, State = X> + ?Sized>(
        &mut self,
        dynamics: &D,
        h: f64,
        time_scale: f64,
    ) -> (Compensated<X>, Attempt)
    where
        X: VectorSpace<S>,
    {
        let from = self.state.reduced(dynamics);
        // First same as last.
        self.stages[0] = self.stages[STAGES].clone();
        let mut sums = StageSums::new(&self.stages[0]);
        self.evaluate(dynamics, &from, h, &mut sums);
        let slope = sums.slope(STAGES);
        let state = self.state.plus(slope.map(|slope| slope * S::from_f64(h)));
        let tolerance = self.method.tolerance.over(S::from_f64(time_scale));
        let allowed = |state: &Compensated<X>| dynamics.allowed_error(state.value(), &tolerance);
        let allowed = [allowed(&self.state), allowed(&state)];
        let error = step_control::error(sums.errors(), h, &allowed);
        let attempted = Attempted {
            stages: &self.stages,
            h,
            ends: [self.state.value(), state.value()],
            allowed: &allowed,
            tolerance: self.method.tolerance,
        };
        let error = attempted.error(error);
        let finite = checked_state(dynamics, self.clock.after(h), state.value());
        (state, Attempt { error, finite })
    }

    /// Chooses the size of the first step, in the direction of `remaining`, and the time scale of the motion.
    fn first_step<S: Scalar, D: Dynamics<S, State = X> + ?Sized>(
        &mut self,
        dynamics: &D,
        remaining: f64,
    ) -> StepControl
    where
        X: VectorSpace<S>,
    {
        let longest = self.limited(remaining.abs());
        let (x, slope) = (self.state.value(), &self.stages[STAGES]);
        let tolerance = self.method.tolerance;
        let time_scale = tolerance.time_scale(dynamics, x, slope);
        let time_scale =
            time_scale.map(|time| time.clamp(MIN_TIME_SCALE * remaining.abs(), remaining.abs()));
        if let Some(step) = self.method.initial_step {
            return StepControl::new(step.min(longest), time_scale);
        }
        self.statistics.evaluations += 1;
        let from = (self.clock, x, slope);
        let signed = longest.copysign(remaining);
        let step = initial_step(dynamics, from, signed, time_scale, tolerance);
        let step = step.max(self.rounding()).min(longest);
        StepControl::new(step, time_scale)
    }

    /// The step size below which steps may be lost in the rounding of times.
    fn rounding(&self) -> f64 {
        let rounding = limits::MIN_STEP * f64::EPSILON * self.clock.time().abs();
        rounding.max(f64::MIN_POSITIVE)
    }

    /// Returns the step size nearest to `step` within the limits that are set.
    pub(super) fn limited(&self, step: f64) -> f64 {
        let step = self.method.max_step.map_or(step, |max| step.min(max));
        self.method.min_step.map_or(step, |min| step.max(min))
    }

    /// Whether a rejected step of size `h` cannot be shortened to `next`: it was the smallest that is allowed, or
    /// `next` would be lost in the rounding of times.
    fn is_smallest(&self, h: f64, next: f64) -> bool {
        next <= self.rounding() || self.method.min_step.is_some_and(|min| h.abs() <= min)
    }
}

impl<S: Scalar, X: VectorSpace<S>> Stepper<S, X> for Dop853Stepper<X> {
    const DENSE_OUTPUT: bool = true;

    fn time(&self) -> f64 {
        self.clock.time()
    }

    fn state(&self) -> &X {
        self.state.value()
    }

    fn previous_time(&self) -> f64 {
        self.last
            .as_ref()
            .map_or(self.clock, |last| last.clock)
            .time()
    }

    fn statistics(&self) -> Statistics {
        self.statistics
    }
}

impl<S: Scalar, X: VectorSpace<S>, D: Dynamics<S, State = X> + ?Sized> Advance<S, D>
    for Dop853Stepper<X>
{
    fn step(&mut self, dynamics: &D, target: f64) -> Result<(), IntegrationError> {
        let Some(remaining) = remaining(&self.clock, target)? else {
            return Ok(());
        };
        let mut control = match self.control {
            Some(control) => control,
            None => self.first_step(dynamics, remaining),
        };
        self.last = None;
        loop {
            let proposed = self.limited(control.step());
            // A step after which the time rounds to the target has not quite arrived: it is made to land on the target.
            #[allow(clippy::float_cmp)] // Exact equality is intended.
            let is_near = self.clock.after(proposed.copysign(remaining)) == target;
            let h = if is_near || limits::LANDING * proposed >= remaining.abs() {
                remaining
            } else {
                proposed.copysign(remaining)
            };
            let (h, state, attempt, clearance) = if self.method.passes_singularities {
                self.attempt_passing(dynamics, h, &control)
            } else {
                let (state, attempt) = self.attempt(dynamics, h, control.time_scale(h));
                (h, state, attempt, Clearance::UNLIMITED)
            };
            let stalls = control.stalls(h, remaining);
            if !stalls && control.accepts(&attempt, h.abs()) {
                let landing = (h.abs() >= remaining.abs()).then_some(target);
                let is_limited = !clearance.is_small();
                let limits = (control.time_scale(h), is_limited);
                let state = self.projected(dynamics, state, (h, landing), limits)?;
                self.accept(dynamics, state, h, landing);
                self.control = Some(control);
                return Ok(());
            }
            if self.statistics.steps > 0 {
                self.statistics.rejected += 1;
            }
            if stalls || self.is_smallest(h, control.step()) {
                attempt.finite?;
                let here = (self.clock.time(), self.state.value());
                let step = control.step();
                if let Some(longest) = self.method.max_step.filter(|longest| *longest < step) {
                    return Err(IntegrationError::StepTooSmall {
                        time: here.0,
                        step: longest,
                        component: None,
                        relative_only: false,
                    });
                }
                let time_scale = S::from_f64(control.time_scale(step));
                let tolerance = self.method.tolerance.over(time_scale);
                let is_limited = |min: &f64| !stalls && h.abs() <= *min;
                let smallest = self.method.min_step.filter(is_limited).map(|_| h.abs());
                let steps = (step, smallest);
                return Err(too_small(dynamics, here, steps, &self.stages, tolerance));
            }
        }
    }

    fn interpolate(&mut self, dynamics: &D, t: f64) -> X {
        self.complete_stages(dynamics);
        match &self.last {
            Some(LastStep {
                clock,
                h,
                dense: Some(polynomial),
                ..
            }) => polynomial.at(clock.until(t) / h),
            _ => self.state.value().clone(),
        }
    }

    fn restart(&mut self, dynamics: &D) {
        let t = S::from_f64(self.clock.time());
        self.stages[STAGES] = derivative_apart(dynamics, t, &self.state.reduced(dynamics));
        self.statistics.evaluations += 1;
        self.control = None;
        self.last = None;
    }

    fn restart_at(&mut self, dynamics: &D, t: f64, x: X) -> Result<(), IntegrationError> {
        let statistics = self.statistics;
        *self = Self::new(self.method, dynamics, t, x)?;
        self.statistics = self.statistics.plus(statistics);
        Ok(())
    }
}

impl<S: Scalar, X: VectorSpace<S>, D: Dynamics<S, State = X> + ?Sized> DenseOutput<S, D>
    for Dop853Stepper<X>
{
    type Interpolant = Dop853Interpolant<X>;

    fn interpolant(&mut self, dynamics: &D) -> Option<Self::Interpolant> {
        self.complete_stages(dynamics);
        let last = self.last.as_ref()?;
        Some(Dop853Interpolant {
            clock: last.clock,
            h: last.h,
            polynomial: last.dense.clone()?,
        })
    }
}

impl<X> Dop853Stepper<X> {
    /// Computes the additional stages of the last step, unless they are known.
    fn complete_stages<S: Scalar, D: Dynamics<S, State = X> + ?Sized>(&mut self, dynamics: &D)
    where
        X: VectorSpace<S>,
    {
        let Some(mut last) = self.last.take() else {
            return;
        };
        if last.dense.is_none() {
            let from = last.x.reduced(dynamics);
            for i in STAGES + 1..ALL_STAGES {
                let at = stage_state(&from, last.h, MATRIX[i], &self.stages);
                let t = S::from_f64(last.clock.after(NODES[i] * last.h));
                self.stages[i] = derivative_apart(dynamics, t, &at);
                self.statistics.evaluations += 1;
            }
            let (start, end) = (last.x.value(), self.state.value());
            last.dense = Some(DensePolynomial::new(start, end, last.h, &self.stages));
        }
        self.last = Some(last);
    }

    /// Returns the end of an accepted step, projected onto the manifold of the dynamics if they have one. The
    /// derivative at the end of the step and dense output are computed from it.
    #[inline]
    fn projected<S: Scalar, D: Dynamics<S, State = X> + ?Sized>(
        &mut self,
        dynamics: &D,
        state: Compensated<X>,
        (h, landing): (f64, Option<f64>),
        (time_scale, is_limited): (f64, bool),
    ) -> Result<Compensated<X>, IntegrationError>
    where
        X: VectorSpace<S>,
    {
        let mut clock = self.clock;
        clock.advance(h);
        let t = S::from_f64(landing.unwrap_or(clock.time()));
        let before = self.state.value();
        let step = Projected {
            dynamics,
            t,
            before,
            length: S::from_f64(h.abs()),
            lane: None,
        };
        let tolerance = self.method.tolerance.over(S::from_f64(time_scale));
        let allowed = |_: &X, end: &X| {
            let [before, after] = [before, end].map(|x| dynamics.allowed_error(x, &tolerance));
            before.zip_map(&after, Scalar::max)
        };
        step.end(state, allowed, is_limited, &mut self.statistics)
    }

    /// Accepts `state`, at the time `landing` if there is one, otherwise after a step `h` from now.
    fn accept<S: Scalar, D: Dynamics<S, State = X> + ?Sized>(
        &mut self,
        dynamics: &D,
        state: Compensated<X>,
        h: f64,
        landing: Option<f64>,
    ) where
        X: VectorSpace<S>,
    {
        self.last = Some(LastStep {
            clock: self.clock,
            x: core::mem::replace(&mut self.state, state),
            h,
            dense: None,
        });
        match landing {
            Some(target) => self.clock = Clock::new(target),
            None => self.clock.advance(h),
        }
        let t = S::from_f64(self.clock.time());
        // The code of the derivative occurs once in the code of a step, in the loop over the other stages. A second
        // copy would keep the compiler from inlining either.
        self.stages[STAGES] = derivative_apart(dynamics, t, &self.state.reduced(dynamics));
        self.statistics.evaluations += 1;
        self.statistics.steps += 1;
    }
}
