//! Integrations in progress, as values that are stepped by hand.

use super::at::{At, InitialValue};
use super::checkpoint::{Checkpoint, EventSigns, Resume};
use super::collector::Uncollected;
use super::driver::{Driver, check_times};
use super::dynamics::Dynamics;
use super::error::IntegrationError;
use super::event::Remembers as _;
use super::integrator::Integrator;
use super::observer::Observer;
use super::outcome::{Outcome, StopReason};
use super::reacting::Unreacting;
use super::stepper::{Advance, Statistics, Stepper};
use super::stop_condition::StopCondition;
use crate::scalar::Scalar;

impl<I, C, O> Driver<I, C, O> {
    /// An integration in progress, from `initial` on: it is stepped, asked and changed by hand.
    ///
    /// # Errors
    ///
    /// Any of [`IntegrationError`].
    pub fn start<S: Scalar, D: Dynamics<S> + ?Sized>(
        self,
        dynamics: &D,
        initial: impl InitialValue<D::State>,
    ) -> Result<RunningIntegration<'_, S, D, I, C, O>, IntegrationError>
    where
        I: Integrator<S, D>,
        C: StopCondition<S, D>,
    {
        let initial = initial.into_initial();
        let stepper = self.begin(dynamics, &initial)?;
        Ok(RunningIntegration::new(self, dynamics, stepper, None))
    }

    /// The integration that goes on from a checkpoint, to the last bit as if it had not stopped if the dynamics and the
    /// settings are the same. Other dynamics, such as those of other parameters, begin there anew.
    ///
    /// # Errors
    ///
    /// If a setting is invalid, or the state is not finite or singular.
    pub fn resume<S: Scalar, D: Dynamics<S> + ?Sized>(
        self,
        dynamics: &D,
        checkpoint: Checkpoint<I::Memory>,
    ) -> Result<RunningIntegration<'_, S, D, I, C, O>, IntegrationError>
    where
        I: Resume<S, D>,
        C: StopCondition<S, D>,
    {
        let Checkpoint { memory, events } = checkpoint;
        let stepper = self.integrator.recall(dynamics, memory)?;
        let (t, x) = (stepper.time(), stepper.state().clone());
        self.check_state(dynamics, &At { t, x })?;
        Ok(RunningIntegration::new(self, dynamics, stepper, events))
    }
}

/// An integration in progress, made by [`Driver::start`](crate::Driver::start).
///
/// It goes on towards any time, step by step or at once, and never beyond it; the conditions and the observer of its
/// driver are with it. Between two steps it can be asked within the last one, and its state or its dynamics can be
/// changed. Nothing is allocated.
///
/// Each event is reported by one call: one that is at the end of a call to rounding by that call
/// ([`Driver::events`](crate::Driver::events)), also where the dynamics are changed there.
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
/// let pendulum = Pendulum { m: 1.0, g: 9.81, l: 1.0 };
/// let dynamics = pendulum.dynamics();
/// let start = State::new(0.0, [0.5], [0.0]);
/// let mut integration = Dop853::new().driver().start(&dynamics, start)?;
///
/// // Step by step, with the state in the middle of each.
/// for step in integration.steps_to(1.0) {
///     let step = step?;
///     assert!(step.start < step.end.t);
/// }
/// integration.advance_to(2.0)?;
/// assert_eq!(integration.time(), 2.0);
/// let middle = 0.5 * (integration.previous_time() + integration.time());
/// let theta = integration.at(middle)?.q[0];
/// assert!(theta.abs() < 0.5);
///
/// // A blow, and on a shorter string.
/// let mut x = *integration.state();
/// x.v[0] += 1.0;
/// integration.restart(x)?;
/// let shorter = Pendulum { l: 0.5, ..pendulum };
/// let shorter = shorter.dynamics();
/// integration.change_dynamics(&shorter)?;
/// integration.advance_to(3.0)?;
/// # Ok::<(), IntegrationError>(())
/// ```
pub struct RunningIntegration<'a, S, D, I, C, O>
where
    S: Scalar,
    D: Dynamics<S> + ?Sized,
    I: Integrator<S, D>,
    C: StopCondition<S, D>,
{
    driver: Driver<I, C, O>,
    dynamics: &'a D,
    stepper: I::Stepper,
    /// What is known of event functions at the end of the last step, if the integration goes on from there.
    memory: Option<C::Memory>,
    /// The same as far as a checkpoint has it.
    events: Option<EventSigns>,
}

/// A step of a [`RunningIntegration`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Step<X> {
    /// The time at which it begins.
    pub start: f64,
    /// The time and the state at which it ends, or where a condition stopped within it.
    pub end: At<f64, X>,
    /// Why there is no other step to the time that was given; none if there is.
    pub stop: Option<StopReason>,
}

impl<'a, S, D, I, C, O> RunningIntegration<'a, S, D, I, C, O>
where
    S: Scalar,
    D: Dynamics<S> + ?Sized,
    I: Integrator<S, D>,
    C: StopCondition<S, D>,
{
    pub(super) fn new(
        driver: Driver<I, C, O>,
        dynamics: &'a D,
        stepper: I::Stepper,
        events: Option<EventSigns>,
    ) -> Self {
        Self {
            driver,
            dynamics,
            stepper,
            memory: None,
            events,
        }
    }

    /// What is known of event functions is forgotten: the integration begins anew.
    fn forget_events(&mut self) {
        (self.memory, self.events) = (None, None);
    }

    /// What is known of event functions, if the integration goes on in the same direction.
    fn recall_events(&mut self, end: f64) -> Option<C::Memory> {
        let (t, x) = (self.time(), self.stepper.state());
        let condition = self.driver.condition_mut();
        let known = match (self.memory.take(), self.events.take()) {
            (Some(memory), _) => Some(memory),
            (None, Some(signs)) => Some(condition.begin(self.dynamics, t, x).recalled(signs)),
            (None, None) => None,
        };
        known.filter(|memory| memory.goes_on(t, end))
    }

    /// The time reached.
    pub fn time(&self) -> f64 {
        self.stepper.time()
    }

    /// The state at that time.
    pub fn state(&self) -> &D::State {
        self.stepper.state()
    }

    /// Time and state.
    pub fn sample(&self) -> At<f64, D::State> {
        At {
            t: self.time(),
            x: self.state().clone(),
        }
    }

    /// The time from which the last step was taken.
    pub fn previous_time(&self) -> f64 {
        self.stepper.previous_time()
    }

    /// The cost so far, restarts included.
    pub fn statistics(&self) -> Statistics {
        self.stepper.statistics()
    }

    /// What takes the steps; its dense output is [`DenseOutput::interpolant`](crate::DenseOutput::interpolant).
    pub fn stepper_mut(&mut self) -> &mut I::Stepper {
        &mut self.stepper
    }

    /// The whole state of the integration, from which it can go on later.
    pub fn checkpoint(&self) -> Checkpoint<I::Memory>
    where
        I: Resume<S, D>,
    {
        Checkpoint {
            memory: I::memory(&self.stepper),
            events: self
                .memory
                .as_ref()
                .map(C::Memory::event_signs)
                .or(self.events),
        }
    }

    /// The state at a time within the last step: by dense output, or for a method that has none as accurately as a step.
    ///
    /// # Errors
    ///
    /// [`IntegrationError::OutsideSolution`] for another time.
    pub fn at(&mut self, t: f64) -> Result<D::State, IntegrationError> {
        let (start, end) = (self.previous_time(), self.time());
        if t - end == 0.0 {
            return Ok(self.state().clone());
        }
        if (start.min(end)..=start.max(end)).contains(&t) {
            Ok(self.stepper.interpolate(self.dynamics, t))
        } else {
            Err(IntegrationError::OutsideSolution {
                time: t,
                start,
                end,
            })
        }
    }

    /// Goes on from another state at the present time, such as that after an impact.
    ///
    /// # Errors
    ///
    /// If the state or its derivative is not finite, or the state singular; nothing is changed then.
    pub fn restart(&mut self, x: D::State) -> Result<(), IntegrationError> {
        let t = self.time();
        let initial = At { t, x };
        self.driver.check_state(self.dynamics, &initial)?;
        self.forget_events();
        self.stepper.restart_at(self.dynamics, t, initial.x)
    }

    /// Goes on with other dynamics from the present state: with other parameters, or another input that is held.
    ///
    /// # Errors
    ///
    /// If the derivative is not finite, or the state singular; nothing is changed then.
    pub fn change_dynamics(&mut self, dynamics: &'a D) -> Result<(), IntegrationError> {
        let here = self.sample();
        self.driver.check_state(dynamics, &here)?;
        self.forget_events();
        self.stepper.restart_at(dynamics, here.t, here.x)?;
        self.dynamics = dynamics;
        Ok(())
    }
}

impl<'a, S, D, I, C, O> RunningIntegration<'a, S, D, I, C, O>
where
    S: Scalar,
    D: Dynamics<S> + ?Sized,
    I: Integrator<S, D>,
    C: StopCondition<S, D>,
    O: Observer<D::State>,
{
    /// Integrates until the time `end`, which may lie before the present one, until a condition or the observer stops,
    /// or until the steps that the driver allows are taken. Called again, it goes on to the last bit as if it had not
    /// stopped, except after a condition that is located within a step.
    ///
    /// # Errors
    ///
    /// Any of [`IntegrationError`].
    pub fn advance_to(&mut self, end: f64) -> Result<Outcome<D::State>, IntegrationError> {
        self.advance(end, self.driver.steps_at_a_time())
    }

    /// Takes one step towards the time `end`; none at that time.
    ///
    /// # Errors
    ///
    /// Any of [`IntegrationError`].
    pub fn step_towards(&mut self, end: f64) -> Result<Option<Step<D::State>>, IntegrationError> {
        let start = self.time();
        let steps = self.statistics().steps;
        let outcome = self.advance(end, 1)?;
        let stop = Some(outcome.reason).filter(|reason| *reason != StopReason::StepLimit);
        let step = Step {
            start,
            end: outcome.last,
            stop,
        };
        Ok(Some(step).filter(|_| self.statistics().steps > steps))
    }

    /// The steps to the time `end`, taken one by one; the last is that at `end`, or that in which a condition or the
    /// observer stops. After an error there is none.
    pub fn steps_to<'r>(&'r mut self, end: f64) -> Steps<'r, 'a, S, D, I, C, O> {
        Steps {
            integration: self,
            end,
            is_over: false,
        }
    }

    fn advance(&mut self, end: f64, steps: u64) -> Result<Outcome<D::State>, IntegrationError> {
        check_times(self.time(), &[end])?;
        self.memory = self.recall_events(end);
        let (dynamics, stepper) = (self.dynamics, &mut self.stepper);
        let (outcome, result) = self.driver.advance(
            &mut Unreacting(dynamics),
            (&mut *stepper, &mut self.memory),
            &[end],
            steps,
            &mut Uncollected,
        );
        let t = outcome.last.t;
        let mut returned = Ok(());
        if t - self.time() != 0.0 {
            // The derivative parts of the state at an event are those at a time that moves.
            let x = self.stepper.interpolate(dynamics, t);
            self.forget_events();
            returned = self.stepper.restart_at(dynamics, t, x);
        }
        if result.is_err() {
            self.forget_events();
        }
        result.and(returned)?;
        Ok(outcome)
    }
}

/// The steps of a [`RunningIntegration`] to a time, made by [`RunningIntegration::steps_to`].
pub struct Steps<'r, 'a, S, D, I, C, O>
where
    S: Scalar,
    D: Dynamics<S> + ?Sized,
    I: Integrator<S, D>,
    C: StopCondition<S, D>,
{
    integration: &'r mut RunningIntegration<'a, S, D, I, C, O>,
    end: f64,
    is_over: bool,
}

impl<S, D, I, C, O> Iterator for Steps<'_, '_, S, D, I, C, O>
where
    S: Scalar,
    D: Dynamics<S> + ?Sized,
    I: Integrator<S, D>,
    C: StopCondition<S, D>,
    O: Observer<D::State>,
{
    type Item = Result<Step<D::State>, IntegrationError>;

    fn next(&mut self) -> Option<Self::Item> {
        if self.is_over {
            return None;
        }
        let step = self.integration.step_towards(self.end).transpose();
        let goes_on = |step: &Self::Item| step.as_ref().is_ok_and(|step| step.stop.is_none());
        self.is_over = !step.as_ref().is_some_and(goes_on);
        step
    }
}
