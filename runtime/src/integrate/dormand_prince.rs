//! The Dormand–Prince method 8(5,3), DOP853.
//!
//! P. J. Prince & J. R. Dormand, *High order embedded Runge–Kutta formulae*, J. Comput. Appl. Math. **7** (1981) 67–75;
//! Hairer, Nørsett & Wanner, *Solving Ordinary Differential Equations I*, 2nd edition (1993), II.4 (step size control),
//! II.5 (the method), II.6 and II.10 (dense output and error estimate). Steps are chosen as by their code DOP853.

mod coefficients;
mod dense_output;
mod step_control;

use super::compensated::{Clock, Compensated};
use super::dynamics::Dynamics;
use super::error::IntegrationError;
use super::integrator::{IntegrationMethod, Integrator};
use super::runge_kutta::{combination, stage};
use super::stepper::{Advance, Statistics, Stepper};
use super::stepper::{checked_derivative, checked_state, remaining};
use super::tolerance::Tolerance;
use crate::limits::dormand_prince as limits;
use crate::linalg::VectorSpace;
use crate::scalar::Scalar;
use coefficients::{MATRIX, NODES, WEIGHTS};
use dense_output::DenseOutput;
use step_control::{Attempt, StepControl, too_small};

/// Stages of the method, without the derivative at the end of the step, which is the first stage of
/// the next step (first same as last).
const STAGES: usize = 12;

/// The stages, the derivative at the end of the step, and the three additional stages of the dense output.
const ALL_STAGES: usize = 16;

/// The Dormand–Prince method 8(5,3) with step-size control and dense output of order 7.
///
/// A step is accepted when the root mean square over the components of
/// errorᵢ / (absolute + relative · scaleᵢ) is at most 1. The scale of a component is the larger of
/// |xᵢ| before and after the step, and 1 for a coordinate that is an angle
/// ([`Dynamics::error_scale`]).
///
/// The default of both tolerances is 10⁻¹⁰. One of them may be zero. Without an absolute tolerance an
/// integration may start from rest, but steps become ever smaller where a component comes near to zero and is not
/// exactly zero. The integration ends near a singularity of the
/// mass matrix where the estimated relative error of the accelerations exceeds the relative
/// tolerance ([`Driver::singularity_tolerance`](crate::Driver::singularity_tolerance)).
///
/// ```
/// use lagrangian::prelude::*;
/// use lagrangian::nalgebra::SVector;
///
/// /// ẍ = −x.
/// struct Oscillator;
///
/// impl Dynamics for Oscillator {
///     type State = SVector<f64, 2>;
///
///     fn derivative(&self, _: f64, x: &Self::State) -> Self::State {
///         SVector::from([x[1], -x[0]])
///     }
/// }
///
/// let initial = (0.0, SVector::from([1.0, 0.0]));
/// let method = Dop853::new().relative_tolerance(1e-12).absolute_tolerance(1e-12);
/// let trajectory = method.sample(&Oscillator, initial, &[1.0, 2.0, 3.0])?;
/// for sample in trajectory.samples() {
///     assert!((sample.x[0] - sample.t.cos()).abs() < 1e-11);
/// }
/// # Ok::<(), IntegrationError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Dop853 {
    tolerance: Tolerance,
    initial_step: Option<f64>,
    max_step: Option<f64>,
    min_step: f64,
}

impl Dop853 {
    /// The method with its default settings.
    #[must_use]
    pub fn new() -> Self {
        Self {
            tolerance: Tolerance {
                relative: limits::TOLERANCE,
                absolute: limits::TOLERANCE,
            },
            initial_step: None,
            max_step: None,
            min_step: limits::MIN_STEP,
        }
    }

    /// Sets the tolerance of the error of a step relative to the scale of a component.
    #[must_use]
    pub fn relative_tolerance(mut self, relative: f64) -> Self {
        self.tolerance.relative = relative;
        self
    }

    /// Sets the tolerance of the error of a step in the units of a component.
    #[must_use]
    pub fn absolute_tolerance(mut self, absolute: f64) -> Self {
        self.tolerance.absolute = absolute;
        self
    }

    /// Sets the size of the first step, in place of the automatic choice.
    #[must_use]
    pub fn initial_step(mut self, step: f64) -> Self {
        self.initial_step = Some(step);
        self
    }

    /// Sets the largest step size.
    #[must_use]
    pub fn max_step(mut self, step: f64) -> Self {
        self.max_step = Some(step);
        self
    }

    /// Sets the smallest step size, as a multiple of the spacing ε |t| of numbers at
    /// the time t. The default is 10.
    #[must_use]
    pub fn min_step(mut self, spacings: f64) -> Self {
        self.min_step = spacings;
        self
    }

    fn check(&self) -> Result<(), IntegrationError> {
        let steps = [self.initial_step, self.max_step];
        for step in steps.into_iter().flatten() {
            if !(step.is_finite() && step > 0.0) {
                return Err(IntegrationError::InvalidStep { step });
            }
        }
        if !(self.min_step.is_finite() && self.min_step >= 0.0) {
            return Err(IntegrationError::InvalidStep {
                step: self.min_step,
            });
        }
        self.tolerance.check()
    }
}

impl Default for Dop853 {
    fn default() -> Self {
        Self::new()
    }
}

impl IntegrationMethod for Dop853 {}

impl<S: Scalar, D: Dynamics<S> + ?Sized> Integrator<S, D> for Dop853 {
    type Stepper = Dop853Stepper<D::State>;

    fn start(&self, dynamics: &D, t: f64, x: D::State) -> Result<Self::Stepper, IntegrationError> {
        self.check()?;
        let derivative = checked_derivative(dynamics, t, &x)?;
        let clock = Clock::new(t);
        Ok(Dop853Stepper {
            method: *self,
            clock,
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

    fn singularity_tolerance(&self) -> f64 {
        self.tolerance.relative
    }
}

/// Takes the steps of [`Dop853`].
///
/// Time and state are compensated sums, so that their rounding errors do not grow over a long integration.
#[derive(Clone, Debug)]
pub struct Dop853Stepper<X> {
    method: Dop853,
    clock: Clock,
    state: Compensated<X>,
    /// The size of the next step, once the first is chosen.
    control: Option<StepControl>,
    /// The derivatives kᵢ of the last step; the one at `STAGES` is that of the present state.
    stages: [X; ALL_STAGES],
    last: Option<LastStep<X>>,
    statistics: Statistics,
}

/// The last step, as dense output needs it.
#[derive(Clone, Debug)]
struct LastStep<X> {
    clock: Clock,
    x: Compensated<X>,
    h: f64,
    dense: Option<DenseOutput<X>>,
}

impl<X> Dop853Stepper<X> {
    /// The derivatives kᵢ of a range of stages, over a step h from (t, x), where x is reduced.
    #[inline]
    fn evaluate<S: Scalar, D: Dynamics<S, State = X> + ?Sized>(
        &mut self,
        dynamics: &D,
        from: (Clock, &X),
        h: f64,
        stages: core::ops::Range<usize>,
    ) where
        X: VectorSpace<S>,
    {
        let (clock, x) = from;
        let rows = NODES.iter().zip(MATRIX).enumerate();
        for (i, (node, row)) in rows.take(stages.end).skip(stages.start) {
            let (done, rest) = self.stages.split_at_mut(i);
            if let Some(next) = rest.first_mut() {
                *next = stage(dynamics, clock.after(node * h), x, h, row, done);
                self.statistics.evaluations += 1;
            }
        }
    }

    /// Computes a step of size `h` and its error; the state does not change.
    fn attempt<S: Scalar, D: Dynamics<S, State = X> + ?Sized>(
        &mut self,
        dynamics: &D,
        h: f64,
    ) -> (Compensated<X>, Attempt)
    where
        X: VectorSpace<S>,
    {
        let from = self.state.reduced(dynamics);
        // First same as last.
        self.stages[0] = self.stages[STAGES].clone();
        self.evaluate(dynamics, (self.clock, &from), h, 1..STAGES);
        let slope = combination(&WEIGHTS, &self.stages, &from.zeroed());
        let state = self.state.plus(slope.map(|slope| slope * S::from_f64(h)));
        let scales = [
            dynamics.error_scale(self.state.value()),
            dynamics.error_scale(state.value()),
        ];
        let error = step_control::error(&self.stages, h, &scales, self.method.tolerance);
        let finite = checked_state(dynamics, self.clock.after(h), state.value());
        (state, Attempt { error, finite })
    }

    /// The size of the first step, in the direction of `remaining`.
    fn first_step<S: Scalar, D: Dynamics<S, State = X> + ?Sized>(
        &mut self,
        dynamics: &D,
        remaining: f64,
    ) -> f64
    where
        X: VectorSpace<S>,
    {
        let longest = self.limited(remaining.abs());
        if let Some(step) = self.method.initial_step {
            return step.min(longest);
        }
        self.statistics.evaluations += 1;
        step_control::initial_step(
            dynamics,
            self.clock,
            self.state.value(),
            &self.stages[STAGES],
            longest.copysign(remaining),
            self.method.tolerance,
        )
    }

    fn limited(&self, step: f64) -> f64 {
        self.method.max_step.map_or(step, |most| step.min(most))
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
            None => StepControl::new(self.first_step(dynamics, remaining)),
        };
        self.last = None;
        loop {
            let proposed = self.limited(control.step());
            let lands = limits::LANDING * proposed >= remaining.abs();
            let h = if lands {
                remaining
            } else {
                proposed.copysign(remaining)
            };
            let (state, attempt) = self.attempt(dynamics, h);
            let stalls = control.stalls(h, remaining);
            if !stalls && control.accepts(&attempt, h.abs()) {
                self.accept(dynamics, state, h, lands.then_some(target));
                self.control = Some(control);
                return Ok(());
            }
            if self.statistics.steps > 0 {
                self.statistics.rejected += 1;
            }
            let least = self.method.min_step * f64::EPSILON * self.clock.time().abs();
            if stalls || control.step() <= least.max(f64::MIN_POSITIVE) {
                attempt.finite?;
                let here = (self.clock.time(), self.state.value());
                let (step, tolerance) = (control.step(), self.method.tolerance);
                return Err(too_small(dynamics, here, step, &self.stages, tolerance));
            }
        }
    }

    fn interpolate(&mut self, dynamics: &D, t: f64) -> X {
        let Some(mut last) = self.last.take() else {
            return self.state.value().clone();
        };
        let dense = last.dense.take().unwrap_or_else(|| {
            let from = (last.clock, &last.x.reduced(dynamics));
            self.evaluate(dynamics, from, last.h, STAGES + 1..ALL_STAGES);
            DenseOutput::new(last.x.value(), self.state.value(), last.h, &self.stages)
        });
        let x = dense.at(last.clock.until(t) / last.h);
        last.dense = Some(dense);
        self.last = Some(last);
        x
    }

    fn restart(&mut self, dynamics: &D) {
        let t = S::from_f64(self.clock.time());
        self.stages[STAGES] = dynamics.derivative(t, &self.state.reduced(dynamics));
        self.statistics.evaluations += 1;
        self.control = None;
        self.last = None;
    }
}

impl<X> Dop853Stepper<X> {
    /// Accepts `state`, at the time `landing` or else a step `h` from now.
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
        self.stages[STAGES] = dynamics.derivative(t, &self.state.reduced(dynamics));
        self.statistics.evaluations += 1;
        self.statistics.steps += 1;
    }
}
