//! Problems in progress, until their end.

#![allow(clippy::type_complexity)] // The type of a problem contains its settings.

use super::keep::{Begun, Collecting, Keep};
use super::solution::{Events, Found};
use super::{Limits, Problem};
use crate::integrate::at::At;
use crate::integrate::driver::{Driver, Next};
use crate::integrate::dynamics::Dynamics;
use crate::integrate::error::IntegrationError;
use crate::integrate::event::{MetConditions, OneSigned, Watched};
use crate::integrate::integrator::Integrator;
use crate::integrate::loop_state::{Beginning, LoopState, Steps, Taken};
use crate::integrate::observer::Observer;
use crate::integrate::outcome::Outcome;
use crate::integrate::part::{KeptSoFar, Part};
use crate::integrate::reactions::Reactions;
use crate::integrate::sample_times::SampleTimes as _;
use crate::integrate::stepper::{Statistics, Stepper as _};
use crate::scalar::Scalar;

/// A problem in progress. It takes its own steps, or shares the steps of an ensemble.
pub(crate) struct Member<S, D, I, K, C, R, O>
where
    S: Scalar,
    D: Dynamics<S>,
    I: Integrator<S, D>,
    C: Watched<S, D>,
    K: Keep<S, D, I::Stepper>,
{
    driver: Driver<I, C, O>,
    dynamics: D,
    reactions: R,
    limits: Limits,
    /// The remaining sample times.
    times: K::Times,
    collection: K::Collection,
    events: Events<S, D::State>,
    stepper: I::Stepper,
    memory: C::Memory,
    state: LoopState,
    outcome: Outcome<D::State>,
    result: Result<(), IntegrationError>,
}

impl<S: Scalar, D: Dynamics<S>, K, C, R, O> Problem<S, D, K, C, R, O> {
    /// Starts the problem by a method, until the time `end`. If it cannot start, the error is the result of the
    /// integration.
    #[inline]
    pub(crate) fn into_member<I>(
        self,
        end: f64,
        method: I,
    ) -> Result<Member<S, D, I, K, C, R, O>, Found<S, D::State, K::Kept>>
    where
        I: Integrator<S, D>,
        C: Watched<S, D>,
        K: Keep<S, D, I::Stepper>,
    {
        let (limits, start, mut dynamics) = (self.limits, self.start, self.dynamics);
        dynamics.begin(S::from_f64(start.t), &start.x);
        let mut driver = limits.driver(method, self.watch.conditions, self.watch.observer);
        let Begun {
            times,
            collection,
            checked,
        } = self.keep.begin(&start, Part::whole(start.t, end));
        let course = limits.course(end);
        let begun = checked
            .and_then(|()| course.check())
            .and_then(|()| driver.begin(&dynamics, &start));
        let stepper = match begun {
            Ok(stepper) => stepper,
            Err(error) => {
                let outcome = Outcome::at(start);
                let ended = (outcome, Statistics::default(), Err(error));
                return Err(limits.found::<_, _, _, K>(ended, collection, Events::default()));
            }
        };
        let (state, outcome) = driver.set_out(&stepper, course);
        Ok(Member {
            memory: driver.conditions.begin(&dynamics, start.t, &outcome.last.x),
            driver,
            dynamics,
            reactions: self.watch.reactions,
            limits,
            times,
            collection,
            events: Events::default(),
            stepper,
            state,
            outcome,
            result: Ok(()),
        })
    }
}

impl<S, D, I, K, C, R, O> Member<S, D, I, K, C, R, O>
where
    S: Scalar,
    D: Dynamics<S>,
    I: Integrator<S, D>,
    C: Watched<S, D>,
    R: Reactions<S, D>,
    O: Observer<D::State>,
    K: Keep<S, D, I::Stepper>,
{
    /// Continues until the caller is to take a step, and returns the time towards which to take it. `None` at the end.
    pub(crate) fn go_on(&mut self, steps: Steps) -> Option<f64> {
        // The times that were kept only matter to the parts of a run.
        let mut kept = KeptSoFar::default();
        let mut collector = Collecting {
            kept: &mut self.collection,
            events: &mut self.events,
            so_far: &mut kept,
        };
        let next = self.driver.go_on(
            (&mut self.dynamics, &mut self.reactions),
            (&mut self.stepper, &mut self.memory, &mut self.times),
            (&mut self.state, steps),
            &mut collector,
            &mut self.outcome,
        );
        match next {
            Ok(Next::Step(target)) => return Some(target),
            Ok(Next::End(reason)) => self.outcome.reason = reason,
            Err(error) => self.result = Err(error),
        }
        None
    }

    /// Continues after a step that the stepper has taken.
    pub(crate) fn stepped(&mut self, taken: Taken) -> Option<f64> {
        self.state.beginning = Beginning::Stepped(taken);
        self.go_on(Steps::Shared)
    }

    /// Returns the result of the integration.
    #[inline]
    pub(crate) fn finish(self) -> Found<S, D::State, K::Kept> {
        let ended = (self.outcome, self.stepper.statistics(), self.result);
        self.limits
            .found::<_, _, _, K>(ended, self.collection, self.events)
    }

    pub(crate) fn dynamics(&self) -> &D {
        &self.dynamics
    }

    pub(crate) fn stepper(&self) -> &I::Stepper {
        &self.stepper
    }

    pub(crate) fn stepper_mut(&mut self) -> &mut I::Stepper {
        &mut self.stepper
    }

    /// Returns the smallest relative pivot that does not end the integration.
    pub(crate) fn min_pivot(&self) -> f64 {
        self.state.min_pivot
    }

    /// Sets the last known state to the one before the last step, or to the present state if no step could be taken.
    pub(crate) fn catch_up(&mut self) {
        let (t, x) = (self.stepper.previous_time(), self.stepper.previous_state());
        let x = x.unwrap_or(self.stepper.state()).clone();
        self.outcome.last = At { t, x };
    }

    /// Whether each step is seen by an observer or by what is kept.
    const EXAMINES_EACH_STEP: bool = O::COUNT > 0 || K::READS_STEPS;

    /// Returns the event functions of the dynamics that decide whether a step has to be examined.
    pub(crate) fn deciding_functions(&self) -> MetConditions {
        if Self::EXAMINES_EACH_STEP {
            MetConditions::default()
        } else {
            self.driver.conditions.watched_functions(&self.dynamics)
        }
    }

    /// Whether neither a step between these times, in which these event functions have one sign, nor its end has to be
    /// examined. Conditions that pass over the step note that it was taken, even if the result is false. `attempts` is the number of
    /// steps attempted so far.
    #[inline]
    pub(crate) fn passes_over(
        &mut self,
        step: [f64; 2],
        attempts: impl Fn() -> u64,
        one_signed: OneSigned,
    ) -> bool {
        let [_, time] = step;
        let LoopState { end, update, .. } = self.state;
        // Asked first: conditions that pass over a step need not search it when it is examined for another reason.
        let (memory, dynamics) = (&mut self.memory, &self.dynamics);
        !Self::EXAMINES_EACH_STEP
            && (self.driver.conditions).passes_over(memory, dynamics, step, one_signed)
            && time - end != 0.0
            && update.is_none_or(|update| time - update != 0.0)
            && !self
                .samples_are_due(|sample| sample - time == 0.0 || self.comes_before(sample, time))
            && attempts() < self.state.step_limit
    }

    /// Whether states within a step to this time are needed: by events, by what is kept, or by a sample.
    pub(crate) fn looks_within(&self, time: f64) -> bool {
        let is_asked = C::COUNT > 0 || K::READS_STEPS;
        is_asked || self.samples_are_due(|sample| self.comes_before(sample, time))
    }

    /// Whether there is a next sample, and it is due.
    #[inline]
    fn samples_are_due(&self, is_due: impl Fn(f64) -> bool) -> bool {
        self.times.next().is_some_and(is_due)
    }

    /// Whether `a` comes before `b` in the direction of the integration.
    #[inline]
    fn comes_before(&self, a: f64, b: f64) -> bool {
        if self.state.end >= self.state.start {
            a < b
        } else {
            a > b
        }
    }
}
