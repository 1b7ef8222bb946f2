//! The steps of explicit Runge–Kutta methods.

use super::RungeKutta;
use crate::integrate::checkpoint::Resume;
use crate::integrate::compensated::{Clock, Compensated};
use crate::integrate::dynamics::Dynamics;
use crate::integrate::error::IntegrationError;
use crate::integrate::projected::{Projected, check_start};
use crate::integrate::stepper::{
    Advance, Statistics, Stepper, checked_derivative, checked_state, remaining,
};
use crate::limits::fixed_steps;
use crate::limits::projection::FIXED_STEP_START;
use crate::linalg::{ErrorTolerance, VectorSpace};
use crate::scalar::Scalar;

/// The stepper of a [`RungeKutta`] method.
///
/// Time and state are compensated sums, so that their rounding errors do not grow over a long integration.
#[derive(Clone, Debug)]
pub struct RungeKuttaStepper<X, const STAGES: usize> {
    method: RungeKutta<STAGES>,
    memory: RungeKuttaMemory<X>,
}

/// The stored part of a [`RungeKuttaStepper`]: everything except its method.
#[derive(Clone, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct RungeKuttaMemory<X> {
    clock: Clock,
    state: Compensated<X>,
    /// The time and the state at the beginning of the last step.
    previous: (Clock, Compensated<X>),
    statistics: Statistics,
}

impl<S: Scalar, D: Dynamics<S> + ?Sized, const STAGES: usize> Resume<S, D> for RungeKutta<STAGES> {
    type Memory = RungeKuttaMemory<D::State>;

    fn memory(stepper: &Self::Stepper) -> Self::Memory {
        stepper.memory.clone()
    }

    fn recall(&self, _: &D, memory: Self::Memory) -> Result<Self::Stepper, IntegrationError> {
        self.check()?;
        let method = *self;
        Ok(RungeKuttaStepper { method, memory })
    }
}

impl<X, const STAGES: usize> RungeKuttaStepper<X, STAGES> {
    /// Starts a motion.
    pub(super) fn new<S: Scalar, D: Dynamics<S, State = X> + ?Sized>(
        method: RungeKutta<STAGES>,
        dynamics: &D,
        t: f64,
        x: X,
    ) -> Result<Self, IntegrationError>
    where
        X: VectorSpace<S>,
    {
        checked_derivative(dynamics, t, &x)?;
        check_start(dynamics, t, &x, &error_of_size(FIXED_STEP_START))?;
        let clock = Clock::new(t);
        let state = Compensated::new(x);
        let memory = RungeKuttaMemory {
            clock,
            previous: (clock, state.clone()),
            state,
            statistics: Statistics {
                evaluations: 1,
                ..Statistics::default()
            },
        };
        Ok(Self { method, memory })
    }

    fn count_step(&mut self) {
        self.memory.statistics.steps += 1;
        self.count_evaluations();
    }

    fn count_evaluations(&mut self) {
        self.memory.statistics.evaluations += STAGES as u64;
    }
}

/// Returns the tolerance that allows this part of the size of each component, and the same number if the component is
/// zero.
fn error_of_size<S: Scalar>(part: f64) -> ErrorTolerance<S> {
    ErrorTolerance {
        relative: part,
        absolute: part,
        rate: S::one(),
    }
}

impl<X, const STAGES: usize> RungeKuttaStepper<X, STAGES> {
    /// Returns the end of a step, projected onto the manifold of the dynamics if they have one.
    #[inline]
    fn projected<S: Scalar, D: Dynamics<S, State = X> + ?Sized>(
        &mut self,
        dynamics: &D,
        time: f64,
        state: Compensated<X>,
    ) -> Result<Compensated<X>, IntegrationError>
    where
        X: VectorSpace<S>,
    {
        let Self { memory, .. } = self;
        let step = Projected {
            dynamics,
            t: S::from_f64(time),
            before: memory.state.value(),
            length: S::from_f64((time - memory.clock.time()).abs()),
            lane: None,
        };
        let size = |state: &X, _: &X| dynamics.allowed_error(state, &error_of_size(1.0));
        step.end(state, size, false, &mut memory.statistics)
    }
}

impl<S: Scalar, X: VectorSpace<S>, const STAGES: usize> Stepper<S, X>
    for RungeKuttaStepper<X, STAGES>
{
    const DENSE_OUTPUT: bool = false;

    fn time(&self) -> f64 {
        self.memory.clock.time()
    }

    fn state(&self) -> &X {
        self.memory.state.value()
    }

    fn previous_time(&self) -> f64 {
        self.memory.previous.0.time()
    }

    fn statistics(&self) -> Statistics {
        self.memory.statistics
    }
}

impl<S: Scalar, X: VectorSpace<S>, D: Dynamics<S, State = X> + ?Sized, const STAGES: usize>
    Advance<S, D> for RungeKuttaStepper<X, STAGES>
{
    fn step(&mut self, dynamics: &D, target: f64) -> Result<(), IntegrationError> {
        let Some(remaining) = remaining(&self.memory.clock, target)? else {
            return Ok(());
        };
        // A quotient that is an integer up to rounding must not add a step. It is rounded up by `floor`, which programs
        // contain in any case.
        let quotient = remaining.abs() / self.method.step * (1.0 - fixed_steps::ROUNDING);
        let steps = (-libm::floor(-quotient)).max(1.0);
        let h = remaining / steps;
        if steps > 1.0 && h.abs() <= f64::EPSILON * self.memory.clock.time().abs() {
            return Err(IntegrationError::StepTooSmall {
                time: self.memory.clock.time(),
                step: h.abs(),
                component: None,
                relative_only: false,
            });
        }
        let (clock, x) = (&self.memory.clock, self.memory.state.reduced(dynamics));
        let (h, increment) = if self.method.passes_singularities {
            self.method.passing(dynamics, clock, &x, (h, remaining))
        } else {
            (h, self.method.increment(dynamics, clock, &x, h))
        };
        let mut clock = self.memory.clock;
        if h.abs() < remaining.abs() {
            clock.advance(h);
        } else {
            clock = Clock::new(target);
        }
        let state = self.memory.state.plus(increment);
        checked_state(dynamics, clock.time(), state.value())?;
        let state = self.projected(dynamics, clock.time(), state)?;
        let previous = core::mem::replace(&mut self.memory.state, state);
        self.memory.previous = (self.memory.clock, previous);
        self.memory.clock = clock;
        self.count_step();
        Ok(())
    }

    /// Takes a step of the method from the previous time to `t`; this is as accurate as the step itself, unless a stage comes
    /// close to a singular configuration that the step passed.
    fn interpolate(&mut self, dynamics: &D, t: f64) -> X {
        let (clock, previous) = &self.memory.previous;
        let h = clock.until(t);
        let from = previous.reduced(dynamics);
        let increment = self.method.increment(dynamics, clock, &from, h);
        let mut x = previous.value().clone();
        x.add_scaled(S::one(), &increment);
        self.count_evaluations();
        x
    }

    fn restart(&mut self, _: &D) {}

    fn restart_at(&mut self, dynamics: &D, t: f64, x: X) -> Result<(), IntegrationError> {
        let statistics = self.memory.statistics;
        *self = Self::new(self.method, dynamics, t, x)?;
        self.memory.statistics = self.memory.statistics.plus(statistics);
        Ok(())
    }
}
