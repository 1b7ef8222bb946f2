//! The loop of an integration: steps, samples, events and observations.

use super::at::At;
use super::collector::Collector;
use super::dynamics::Dynamics;
use super::error::IntegrationError;
use super::event::{Detection, LastStep, Located, MetConditions, Occurring, moved};
use super::loop_state::{Beginning, Interruption, LoopState, Steps, Taken};
use super::observer::{ObservationKind, Observer, Progress};
use super::outcome::{Outcome, StopReason};
use super::sample_times::SampleTimes;
use super::singularity::Singularity;
use super::stepper::Advance;
use crate::scalar::Scalar;

/// An integration in progress, during which the dynamics do not change.
pub(crate) struct Integration<'a, S: Scalar, D: Dynamics<S>, T, C: Detection<S, D>, O> {
    pub(crate) dynamics: &'a D,
    pub(crate) stepper: &'a mut T,
    /// The sample times that are left.
    pub(crate) waiting: &'a mut dyn SampleTimes,
    pub(crate) condition: &'a mut C,
    pub(crate) memory: &'a mut C::Memory,
    pub(crate) state: LoopState,
    pub(crate) steps: Steps,
    /// Whether events that do not stop the integration interrupt it.
    pub(crate) reacts: bool,
    /// Events that were found, but before which the integration stops.
    pub(crate) pending: Option<Occurring>,
    pub(crate) observer: &'a mut O,
    pub(crate) collector: &'a mut dyn Collector<S, D, T>,
    /// The error for which a state within the last step could not be shown.
    pub(crate) failure: Option<IntegrationError>,
    /// Up to date at any time, so that it is valid after an error.
    pub(crate) outcome: &'a mut Outcome<D::State>,
}

impl<S, D, T, C, O> Integration<'_, S, D, T, C, O>
where
    S: Scalar,
    D: Dynamics<S>,
    T: Advance<S, D>,
    C: Detection<S, D>,
    O: Observer<D::State>,
{
    /// Processes what precedes the next step: the samples and the condition at the initial time, or the observation of
    /// a change.
    pub(crate) fn begin(&mut self) -> Result<(), StopReason> {
        match self.state.beginning {
            Beginning::Initial => {
                self.samples_until(self.state.start)?;
                self.check_condition()
            }
            Beginning::Changed => self.notify(ObservationKind::Step),
            Beginning::Unchanged => Ok(()),
            Beginning::Stepped(Taken::Failed(error)) => {
                self.close(StopReason::Error);
                Err(self.fail(error))
            }
            Beginning::Stepped(_) => {
                self.state.is_visited = false;
                Ok(())
            }
        }
    }

    /// Takes steps until there is a reason to stop or to react, unless there is one from the beginning. Some events in
    /// the last step may not have been processed then.
    pub(crate) fn complete(
        &mut self,
        begun: Result<(), StopReason>,
    ) -> Result<Interruption, IntegrationError> {
        if let Err(reason) = begun {
            return self.failure.take().map_or(Ok(reason.into()), Err);
        }
        let beginning = self.state.beginning;
        let mut is_regular = matches!(beginning, Beginning::Stepped(Taken::Regular));
        loop {
            let broken = if is_regular { None } else { self.broken_step() };
            is_regular = false;
            let visited = match &broken {
                Some((regular, _)) => self.visit_events_until(*regular),
                None => self.visit_step(),
            };
            if let Err(interruption) = visited {
                return self.failure.take().map_or(Ok(interruption), Err);
            }
            if let Some((regular, error)) = broken {
                self.record_until(regular);
                self.outcome.last = self.at(regular);
                return Err(error);
            }
            if self.stepper.time() - self.state.end == 0.0 {
                return Ok(StopReason::Completed.into());
            }
            if self
                .state
                .update
                .is_some_and(|t| self.stepper.time() - t == 0.0)
            {
                return Ok(Interruption::Update);
            }
            if self.stepper.statistics().attempts() >= self.state.step_limit {
                return Ok(StopReason::StepLimit.into());
            }
            if self.steps == Steps::Shared {
                return Ok(Interruption::Step(self.target()));
            }
            let target = self.target();
            if let Err(error) = self.stepper.step(self.dynamics, target) {
                self.close(StopReason::Error);
                return Err(error);
            }
            self.state.is_visited = false;
        }
    }

    /// Reports the end of a part.
    pub(crate) fn finish(&mut self, interruption: Interruption) -> Interruption {
        let interruption = match interruption {
            Interruption::Stop(reason) => self.close(reason),
            Interruption::Reaction(occurring, Some(reason)) => self.close(reason).after(occurring),
            other => other,
        };
        if !self.state.is_visited {
            // The motion ends, or a reaction interrupts it, within the last step.
            self.record_until(self.outcome.last.t);
        }
        interruption
    }

    /// Reports the events that belong to the part that ends here, where rounding does not distinguish them from its
    /// end.
    fn close(&mut self, reason: StopReason) -> Interruption {
        let here = self.outcome.last.clone();
        let mut step = LastStep::new(self.dynamics, self.stepper);
        let pending = self.pending.take();
        let events = (self.condition).close(self.memory, &mut step, &here, pending);
        if !events.any() {
            return reason.into();
        }
        let met = self.outcome.met;
        // The integration stops in any case.
        let _ = self.report(events, &here);
        self.outcome.met = met;
        if events
            .indices()
            .any(|event| self.condition.is_terminal(event))
        {
            let is_met = reason == StopReason::Condition;
            let met = Some(met).filter(|_| is_met).unwrap_or_default();
            self.outcome.met = met.or(events);
            return StopReason::Condition.into();
        }
        self.outcome.last = here;
        if self.reacts && reason != StopReason::Error {
            let t = self.outcome.last.t;
            return Interruption::Reaction(Occurring { t, events }, Some(reason));
        }
        reason.into()
    }

    /// Returns the time towards which the next step is taken.
    fn target(&self) -> f64 {
        let next = if T::DENSE_OUTPUT {
            None
        } else {
            self.waiting.next()
        };
        let target = next.unwrap_or(self.state.end);
        let update = self.state.update;
        update.map_or(target, |update| update.min(target))
    }

    /// Returns the error for a step that leads to a singularity or beyond a pole, and the last time within the step
    /// before that.
    fn broken_step(&mut self) -> Option<(f64, IntegrationError)> {
        let min_pivot = self.state.min_pivot;
        if self.state.is_visited || min_pivot <= 0.0 {
            return None;
        }
        let (end, x) = (self.stepper.time(), self.stepper.state());
        let (t, before) = (S::from_f64(end), &self.outcome.last.x);
        if let Some(pole) = self.dynamics.singularity_between(before, (t, x)) {
            return Some(self.pole_in_step(pole));
        }
        let found = self.dynamics.singularity_in_motion(t, x, min_pivot)?;
        let error = IntegrationError::singular::<S>(end, found);
        let regular = if self.state.end >= self.state.start {
            end.next_down()
        } else {
            end.next_up()
        };
        Some((regular, error))
    }

    /// Returns the error for a pole beyond which the last step leads, and the last time before it, by bisection.
    #[cold]
    fn pole_in_step(&mut self, mut pole: Singularity) -> (f64, IntegrationError) {
        let mut before = self.outcome.last.clone();
        let mut after = self.stepper.time();
        loop {
            let middle = self.at(0.5 * (before.t + after));
            if middle.t - before.t == 0.0 || middle.t - after == 0.0 {
                return (before.t, IntegrationError::singular::<S>(after, pole));
            }
            let there = (S::from_f64(middle.t), &middle.x);
            match self.dynamics.singularity_between(&before.x, there) {
                Some(found) => (pole, after) = (found, middle.t),
                None => before = middle,
            }
        }
    }

    /// Visits the remaining events in the last step, and then its end.
    fn visit_step(&mut self) -> Result<(), Interruption> {
        if self.state.is_visited {
            return Ok(());
        }
        let end = self.stepper.time();
        // Nearly no step contains anything to visit, if no events are watched.
        if C::COUNT > 0 || self.waiting.next().is_some() {
            self.visit_events_until(end)?;
        }
        self.record_until(end);
        self.state.is_visited = true;
        self.outcome.last = self.at(end);
        self.notify(ObservationKind::Step)?;
        self.check_condition()?;
        Ok(())
    }

    /// Visits the remaining events in the last step up to a time, and takes the samples up to it.
    fn visit_events_until(&mut self, t: f64) -> Result<(), Interruption> {
        loop {
            let mut step = LastStep::new(self.dynamics, self.stepper);
            let Some(occurring) = self.condition.next(self.memory, &mut step) else {
                break;
            };
            if step.comes_before(t, occurring.t) {
                break;
            }
            let there = step.checked_at(occurring.t);
            let there = there.map_err(|error| self.fail(error))?;
            self.visit_event(occurring, &there)?;
        }
        if self.waiting.next().is_some() {
            self.samples_until(t)?;
        }
        Ok(())
    }

    fn visit_event(
        &mut self,
        occurring: Occurring,
        there: &At<f64, D::State>,
    ) -> Result<(), Interruption> {
        if let Err(reason) = self.samples_until(there.t) {
            self.pending = Some(occurring);
            return Err(reason.into());
        }
        let stopped = self.visit_stops(occurring, there);
        if self.reacts {
            return Err(Interruption::Reaction(occurring, stopped.err()));
        }
        Ok(stopped?)
    }

    /// Reports events. Returns the reason to stop if an observer stops or one of the events is terminal.
    fn visit_stops(
        &mut self,
        occurring: Occurring,
        there: &At<f64, D::State>,
    ) -> Result<(), StopReason> {
        self.report(occurring.events, there)?;
        let mut events = occurring.events.indices();
        if events.any(|event| self.condition.is_terminal(event)) {
            self.notify(ObservationKind::Step)?;
            self.outcome.met = occurring.events;
            return Err(StopReason::Condition);
        }
        Ok(())
    }

    /// Reports all events at a time, even if an observer stops at one of them.
    fn report(
        &mut self,
        events: MetConditions,
        there: &At<f64, D::State>,
    ) -> Result<(), StopReason> {
        let mut told = Ok(());
        let mut stopping = MetConditions::default();
        for event in events.indices() {
            let located = Located {
                dynamics: self.dynamics,
                t: there.t,
                x: &there.x,
                step: self.stepper.time() - self.stepper.previous_time(),
            };
            let t = S::from_f64(there.t);
            let delay = located.delay(self.condition, event);
            self.outcome.last = At {
                t: there.t,
                x: moved(self.dynamics, t, &there.x, delay),
            };
            let names = (event, self.condition.declared(event));
            let x = &self.outcome.last.x;
            self.collector.event(names, t + delay, x);
            told = told.and(self.notify(ObservationKind::Event(event)));
            stopping = stopping.or(self.outcome.met);
        }
        self.outcome.met = stopping;
        told
    }

    /// Returns the reason to stop as an error if the condition on the present state holds.
    fn check_condition(&mut self) -> Result<(), StopReason> {
        let holding = (self.condition).holding(self.stepper.time(), self.stepper.state());
        if holding.any() {
            self.outcome.met = holding;
            return Err(StopReason::Condition);
        }
        Ok(())
    }

    /// Takes the samples up to `t` within the last step.
    fn samples_until(&mut self, t: f64) -> Result<(), StopReason> {
        let forwards = self.state.end >= self.state.start;
        while let Some(time) = self.waiting.next() {
            if (forwards && time > t) || (!forwards && time < t) {
                break;
            }
            let sample = LastStep::new(self.dynamics, &mut *self.stepper).checked_at(time);
            self.outcome.last = sample.map_err(|error| self.fail(error))?;
            self.waiting.advance();
            self.collector.sample(&self.outcome.last);
            self.notify(ObservationKind::Sample)?;
        }
        Ok(())
    }

    /// Records the error for which a state within the last step cannot be shown.
    #[cold]
    fn fail(&mut self, error: IntegrationError) -> StopReason {
        self.failure = Some(error);
        StopReason::Error
    }

    /// Passes the last step, which is part of the motion until `end`, to the collector.
    fn record_until(&mut self, end: f64) {
        self.collector.step(self.dynamics, self.stepper, end);
    }

    /// Returns the sample at a time within the last step.
    fn at(&mut self, t: f64) -> At<f64, D::State> {
        LastStep::new(self.dynamics, &mut *self.stepper).at(t)
    }

    fn notify(&mut self, kind: ObservationKind) -> Result<(), StopReason> {
        let progress = Progress {
            kind,
            t: self.outcome.last.t,
            x: &self.outcome.last.x,
            start: self.state.start,
            end: self.state.end,
            statistics: self.stepper.statistics(),
        };
        let stopping = self.observer.observe(&progress);
        if stopping.any() {
            self.outcome.met = stopping;
            return Err(StopReason::Observer);
        }
        Ok(())
    }
}
