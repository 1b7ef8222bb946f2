//! Problems that are integrated step by step.

use core::marker::PhantomData;

use super::keep::{Begun, Collecting, Keep};
use super::solution::{Events, Found, Solution};
use super::{End, Limits, Problem, Watch};
use crate::integrate::at::At;
use crate::integrate::checkpoint::{Checkpoint, EventSigns, Resume};
use crate::integrate::collector::Collector;
use crate::integrate::driver::{Course, Driver};
use crate::integrate::dynamics::Dynamics;
use crate::integrate::error::IntegrationError;
use crate::integrate::event::{LastStep, Remembers as _, Watched};
use crate::integrate::integrator::Integrator;
use crate::integrate::observer::Observer;
use crate::integrate::outcome::Outcome;
use crate::integrate::part::{KeptSoFar, Part};
use crate::integrate::partial::Partial;
use crate::integrate::reactions::Reactions;
use crate::integrate::sample_times::SampleTimes;
use crate::integrate::stepper::{Advance as _, Statistics, Stepper as _};
use crate::scalar::Scalar;

/// An integration in progress, created by [`Problem::start`] or [`Problem::resume`], which is advanced, inspected and
/// changed by hand.
///
/// ```
/// use lagrangian::prelude::*;
///
/// #[derive(Lagrangian)]
/// #[lagrangian(
///     coordinates(theta),
///     kinetic = 0.5 * m * l.powi(2) * dot(theta).powi(2),
///     potential = -m * g * l * cos(theta),
/// )]
/// struct Pendulum { m: f64, g: f64, l: f64 }
///
/// // A game that draws sixty frames a second.
/// let pendulum = Pendulum { m: 1.0, g: 9.81, l: 1.0 };
/// let start = State::new(0.0, [1.0], [0.0]);
/// let mut run = Problem::new(&pendulum, start).start(Dop853::new())?;
/// for frame in 1..=60 {
///     let state = run.advance(f64::from(frame) / 60.0)?;
///     assert!(state.q[0].abs() <= 1.0 + 1e-9);
/// }
/// # Ok::<(), IntegrationError>(())
/// ```
#[derive(Debug)]
pub struct Run<S, D, I, K = End, C = (), R = (), O = ()>
where
    S: Scalar,
    D: Dynamics<S>,
    I: Integrator<S, D>,
    C: Watched<S, D>,
{
    driver: Driver<I, C, O>,
    dynamics: D,
    reactions: R,
    keep: K,
    /// The initial time of the problem.
    origin: f64,
    kept: KeptSoFar,
    limits: Limits,
    stepper: I::Stepper,
    /// What is known about the events, if the integration continues from where it is known.
    memory: Option<C::Memory>,
    /// What a checkpoint knew about the events.
    events: Option<EventSigns>,
    scalar: PhantomData<S>,
}

impl<S: Scalar, D: Dynamics<S>, K, C, R, O> Problem<S, D, K, C, R, O> {
    /// Starts the integration by a method, to be advanced by hand.
    ///
    /// # Errors
    ///
    /// If a setting is invalid, or if the state is not finite, is singular, or violates the
    /// [constraints](Dynamics::project) of the dynamics.
    pub fn start<I>(self, method: I) -> Result<Run<S, D, I, K, C, R, O>, IntegrationError>
    where
        I: Integrator<S, D>,
        C: Watched<S, D>,
    {
        self.begin(method, |driver, dynamics, start| {
            dynamics.begin(S::from_f64(start.t), &start.x);
            Ok((driver.begin(dynamics, start)?, None))
        })
    }

    /// Continues the integration from a checkpoint instead of the start. If the dynamics and the settings are
    /// unchanged, it continues to the last bit as if it had not stopped. With other parameters of the dynamics, the
    /// method restarts there.
    ///
    /// # Errors
    ///
    /// If a setting is invalid, or the state is not finite or singular.
    pub fn resume<I>(
        self,
        checkpoint: Checkpoint<I::Memory>,
        method: I,
    ) -> Result<Run<S, D, I, K, C, R, O>, IntegrationError>
    where
        I: Resume<S, D>,
        C: Watched<S, D>,
    {
        self.begin(method, |driver, dynamics, _| {
            let Checkpoint { memory, events } = checkpoint;
            let stepper = driver.integrator.recall(dynamics, memory.clone())?;
            let (t, x) = (stepper.time(), stepper.state().clone());
            dynamics.begin(S::from_f64(t), &x);
            let stepper = driver.integrator.recall(dynamics, memory)?;
            driver.check_state(dynamics, &At { t, x })?;
            Ok((stepper, events))
        })
    }

    fn begin<I>(
        mut self,
        method: I,
        stepper: impl FnOnce(
            &Driver<I, C, O>,
            &mut D,
            &At<f64, D::State>,
        ) -> Result<(I::Stepper, Option<EventSigns>), IntegrationError>,
    ) -> Result<Run<S, D, I, K, C, R, O>, IntegrationError>
    where
        I: Integrator<S, D>,
        C: Watched<S, D>,
    {
        let Watch {
            conditions,
            reactions,
            observer,
            ..
        } = self.watch;
        let driver = self.limits.driver(method, conditions, observer);
        let (stepper, events) = stepper(&driver, &mut self.dynamics, &self.start)?;
        // Anything at the time of a checkpoint was kept by the run that made it.
        let before = Some(stepper.time()).filter(|t| t - self.start.t != 0.0);
        Ok(Run {
            origin: self.start.t,
            kept: KeptSoFar {
                sample: before,
                step: before,
            },
            driver,
            dynamics: self.dynamics,
            reactions,
            keep: self.keep,
            limits: self.limits,
            stepper,
            memory: None,
            events,
            scalar: PhantomData,
        })
    }
}

impl<S, D, I, K, C, R, O> Run<S, D, I, K, C, R, O>
where
    S: Scalar,
    D: Dynamics<S>,
    I: Integrator<S, D>,
    C: Watched<S, D>,
{
    fn forget_events(&mut self) {
        (self.memory, self.events) = (None, None);
    }

    /// Returns what is known about the events, if it is valid for continuing from here to `end`.
    fn recall_events(&mut self, end: f64) -> Option<C::Memory> {
        let (t, x) = (self.stepper.time(), self.stepper.state());
        let condition = &mut self.driver.conditions;
        let known = match (self.memory.take(), self.events.take()) {
            (Some(memory), _) => Some(memory),
            (None, Some(signs)) => Some(condition.begin(&self.dynamics, t, x).recalled(signs)),
            (None, None) => None,
        };
        known.filter(|memory| memory.goes_on(t, end))
    }

    /// Returns the state reached.
    pub fn state(&self) -> At<S, D::State> {
        let x = self.stepper.state().clone();
        At {
            t: S::from_f64(self.stepper.time()),
            x,
        }
    }

    /// Returns the time at the beginning of the last step.
    pub fn previous_time(&self) -> f64 {
        self.stepper.previous_time()
    }

    /// Returns the statistics so far.
    pub fn statistics(&self) -> Statistics {
        self.stepper.statistics()
    }

    /// Returns the dynamics.
    pub fn dynamics(&self) -> &D {
        &self.dynamics
    }

    /// Returns the stepper of the method, which holds its last step.
    pub fn stepper(&self) -> &I::Stepper {
        &self.stepper
    }

    /// Returns the whole state of the integration, from which [`Problem::resume`] continues.
    pub fn checkpoint(&self) -> Checkpoint<I::Memory>
    where
        I: Resume<S, D>,
    {
        let memory = self.memory.as_ref();
        Checkpoint {
            memory: I::memory(&self.stepper),
            events: memory.map(C::Memory::event_signs).or(self.events),
        }
    }

    /// Returns the state at a time within the last step.
    ///
    /// # Errors
    ///
    /// [`OutsideSolution`](IntegrationError::OutsideSolution), or
    /// [`ProjectionFailed`](IntegrationError::ProjectionFailed).
    pub fn at(&mut self, t: f64) -> Result<At<S, D::State>, IntegrationError> {
        let (start, end) = (self.previous_time(), self.stepper.time());
        if !(start.min(end)..=start.max(end)).contains(&t) {
            return Err(IntegrationError::OutsideSolution {
                time: t,
                start,
                end,
            });
        }
        let At { x, .. } = LastStep::new(&self.dynamics, &mut self.stepper).checked_at(t)?;
        Ok(At {
            t: S::from_f64(t),
            x,
        })
    }

    /// Changes the state, the dynamics, or both, and continues from there, for example when a load is picked up or a
    /// parameter is tuned. The time does not change.
    ///
    /// # Errors
    ///
    /// If the changed state is not finite, is singular, or violates the [constraints](Dynamics::project) of the
    /// dynamics. The state is then as before, but the dynamics stay changed.
    pub fn change(
        &mut self,
        change: impl FnOnce(&mut At<S, D::State>, &mut D),
    ) -> Result<(), IntegrationError> {
        let t = self.stepper.time();
        let mut state = self.state();
        change(&mut state, &mut self.dynamics);
        let here = At { t, x: state.x };
        self.forget_events();
        self.dynamics.begin(S::from_f64(t), &here.x);
        if let Err(error) = self.driver.check_state(&self.dynamics, &here) {
            self.stepper.restart(&self.dynamics);
            return Err(error);
        }
        let restarted = self.stepper.restart_at(&self.dynamics, t, here.x);
        if restarted.is_ok() {
            // The state after the change differs from the state at the end of the step.
            self.kept.step = None;
        } else {
            self.stepper.restart(&self.dynamics);
        }
        restarted
    }
}

impl<S, D, I, K, C, R, O> Run<S, D, I, K, C, R, O>
where
    S: Scalar,
    D: Dynamics<S>,
    I: Integrator<S, D>,
    C: Watched<S, D>,
    R: Reactions<S, D>,
    O: Observer<D::State>,
    K: Keep<S, D, I::Stepper> + Clone,
{
    /// Integrates until the time `end`, or until an event, a condition or an observer stops.
    ///
    /// A step ends at `end`: an integration in parts has other steps than one in one go, and its results differ by
    /// rounding. The solution has the samples and events of this part, and the statistics since the start of the run.
    /// Samples belong to the whole integration: each is kept by the part that reaches it first, and a list of times may
    /// extend beyond this part.
    ///
    /// # Errors
    ///
    /// Any [`IntegrationError`], with the solution up to it. The integration can be continued from there.
    pub fn advance(
        &mut self,
        end: f64,
    ) -> Result<Solution<S, D::State, K::Kept>, Partial<Solution<S, D::State, K::Kept>>> {
        self.advance_by(end, self.limits)
    }

    /// Takes one step towards the time `end`, or its part up to an event. Returns `None` at the end, or if a condition
    /// holds from the start.
    ///
    /// # Errors
    ///
    /// Any [`IntegrationError`].
    pub fn step(
        &mut self,
        end: f64,
    ) -> Result<Option<Solution<S, D::State, K::Kept>>, Partial<Solution<S, D::State, K::Kept>>>
    {
        let steps = self.statistics().steps;
        let one = Limits {
            max_steps: Some(1),
            ..self.limits
        };
        let kept = self.kept;
        let solution = self.advance_by(end, one)?;
        if self.statistics().steps > steps {
            Ok(Some(solution))
        } else {
            // Anything at the start is kept by the next step.
            self.kept = kept;
            Ok(None)
        }
    }

    fn advance_by(&mut self, end: f64, limits: Limits) -> Found<S, D::State, K::Kept> {
        let (t, x) = (self.stepper.time(), self.stepper.state().clone());
        let start = At { t, x };
        let part = Part {
            origin: self.origin,
            end,
            kept: self.kept,
            is_one_of_several: true,
        };
        let Begun {
            mut times,
            mut collection,
            checked,
        } = self.keep.clone().begin(&start, part);
        let (mut events, mut kept) = (Events::default(), self.kept);
        let mut collector = Collecting {
            kept: &mut collection,
            events: &mut events,
            so_far: &mut kept,
        };
        let (outcome, result) = match checked {
            Ok(()) => self.go_on(&start, (limits.course(end), &mut times), &mut collector),
            Err(error) => (Outcome::at(start), Err(error)),
        };
        self.kept = kept;
        let ended = (outcome, self.statistics(), result);
        limits.found::<_, _, _, K>(ended, collection, events)
    }

    /// Advances, then restarts the stepper at the time at which the integration has stopped.
    fn go_on(
        &mut self,
        start: &At<f64, D::State>,
        (course, samples): (Course, &mut dyn SampleTimes),
        collector: &mut dyn Collector<S, D, I::Stepper>,
    ) -> (Outcome<D::State>, Result<(), IntegrationError>) {
        if let Err(error) = course.check() {
            return (Outcome::at(start.clone()), Err(error));
        }
        self.memory = self.recall_events(course.end);
        let system = (&mut self.dynamics, &mut self.reactions);
        let parts = (&mut self.stepper, &mut self.memory, samples);
        let (outcome, mut result) = (self.driver).advance(system, parts, course, collector);
        if result.is_err() {
            self.forget_events();
        }
        let t = outcome.last.t;
        if t - self.stepper.time() != 0.0 {
            // At an event, the derivative parts of the outcome's state belong to a time that moves, so that it is
            // interpolated anew.
            let At { x, .. } = LastStep::new(&self.dynamics, &mut self.stepper).at(t);
            self.forget_events();
            result = result.and(self.stepper.restart_at(&self.dynamics, t, x));
        }
        (outcome, result)
    }
}
