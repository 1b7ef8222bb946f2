//! What a driver does before the first step, and how it goes on.

use super::Driver;
use crate::integrate::at::At;
use crate::integrate::collector::Collector;
use crate::integrate::dynamics::Dynamics;
use crate::integrate::error::IntegrationError;
use crate::integrate::event::{
    LastStep, Located, MetConditions, Occurring, Reaction, differs, moved,
};
use crate::integrate::integration::{Beginning, Integration, Interruption, check_singularity};
use crate::integrate::integrator::Integrator;
use crate::integrate::observer::Observer;
use crate::integrate::outcome::{Outcome, StopReason};
use crate::integrate::reacting::{React, Unreacting};
use crate::integrate::stepper::{Advance, Stepper as _, checked_state};
use crate::integrate::stop_condition::StopCondition;
use crate::limits::MIN_SINGULARITY_TOLERANCE;
use crate::scalar::Scalar;

impl<I, C, O> Driver<I, C, O> {
    /// Passes each sample and each step to the collector. The outcome is known after an error, too.
    pub(crate) fn run<S: Scalar, D: Dynamics<S> + ?Sized>(
        &mut self,
        dynamics: &D,
        initial: &At<f64, D::State>,
        times: &[f64],
        collector: &mut dyn Collector<S, D, I::Stepper>,
    ) -> (Outcome<D::State>, Result<(), IntegrationError>)
    where
        I: Integrator<S, D>,
        C: StopCondition<S, D>,
        O: Observer<D::State>,
    {
        self.run_parts(&mut Unreacting(dynamics), initial, times, collector)
    }

    /// The same, with reactions to events.
    pub(crate) fn run_parts<S: Scalar, D: Dynamics<S> + ?Sized>(
        &mut self,
        system: &mut impl React<S, D>,
        initial: &At<f64, D::State>,
        times: &[f64],
        collector: &mut dyn Collector<S, D, I::Stepper>,
    ) -> (Outcome<D::State>, Result<(), IntegrationError>)
    where
        I: Integrator<S, D>,
        C: StopCondition<S, D>,
        O: Observer<D::State>,
    {
        let checked = check_times(initial.t, times);
        match checked.and_then(|()| self.begin(system.dynamics(), initial)) {
            Ok(mut stepper) => {
                let steps = self.max_steps;
                self.advance(system, (&mut stepper, &mut None), times, steps, collector)
            }
            Err(error) => (Outcome::at(initial.clone()), Err(error)),
        }
    }

    /// Goes on through `times`, which are checked, with at most so many more steps.
    pub(crate) fn advance<S: Scalar, D: Dynamics<S> + ?Sized>(
        &mut self,
        system: &mut impl React<S, D>,
        (stepper, memory): (&mut I::Stepper, &mut Option<C::Memory>),
        times: &[f64],
        steps: u64,
        collector: &mut dyn Collector<S, D, I::Stepper>,
    ) -> (Outcome<D::State>, Result<(), IntegrationError>)
    where
        I: Integrator<S, D>,
        C: StopCondition<S, D>,
        O: Observer<D::State>,
    {
        let (t, x) = (stepper.time(), stepper.state().clone());
        let mut outcome = Outcome::at(At { t, x });
        let begun = memory.take();
        let mut known =
            begun.unwrap_or_else(|| self.condition.begin(system.dynamics(), t, &outcome.last.x));
        let parts = (times, steps);
        let result = self.advance_parts(
            system,
            (&mut *stepper, &mut known),
            parts,
            collector,
            &mut outcome,
        );
        *memory = Some(known);
        let result = result.map(|reason| outcome.reason = reason);
        (outcome, result)
    }

    /// One part after the other, with a reaction between them.
    fn advance_parts<S: Scalar, D: Dynamics<S> + ?Sized, R: React<S, D>>(
        &mut self,
        system: &mut R,
        (stepper, memory): (&mut I::Stepper, &mut C::Memory),
        (mut waiting, steps): (&[f64], u64),
        collector: &mut dyn Collector<S, D, I::Stepper>,
        outcome: &mut Outcome<D::State>,
    ) -> Result<StopReason, IntegrationError>
    where
        I: Integrator<S, D>,
        C: StopCondition<S, D>,
        O: Observer<D::State>,
    {
        let start = outcome.last.t;
        let end = waiting.last().copied().unwrap_or(start);
        let min_pivot = self.min_pivot::<S, D>();
        let step_limit = stepper.statistics().attempts().saturating_add(steps);
        let (mut beginning, mut is_visited) = (Beginning::Initial, true);
        loop {
            let next = update(system.dynamics(), stepper, end)?;
            let mut part = Integration {
                dynamics: system.dynamics(),
                stepper: &mut *stepper,
                start,
                end,
                waiting: &mut waiting,
                min_pivot,
                step_limit,
                condition: &mut self.condition,
                memory: &mut *memory,
                update: next,
                reacts: R::REACTS,
                is_visited,
                pending: None,
                observer: &mut self.observer,
                collector: &mut *collector,
                outcome: &mut *outcome,
            };
            let (occurring, stop) = match part.run(beginning)? {
                Interruption::Stop(reason) => return Ok(reason),
                Interruption::Reaction(occurring, stop) => (occurring, stop),
                Interruption::Update => {
                    (is_visited, beginning) = (true, Beginning::Unchanged);
                    continue;
                }
            };
            is_visited = part.is_visited;
            let (reaction, x) = self.react(system, stepper, occurring);
            match reaction {
                Reaction::Unchanged => beginning = Beginning::Unchanged,
                Reaction::Stop => {
                    outcome.last.x = x;
                    outcome.met = occurring.events;
                    return Ok(StopReason::Condition);
                }
                Reaction::Changed => {
                    let dynamics = system.dynamics();
                    outcome.met = self.begin_anew(dynamics, stepper, memory, occurring, &x)?;
                    outcome.last.x = x;
                    outcome.statistics = stepper.statistics();
                    if outcome.met.any() {
                        return Ok(StopReason::Zeno);
                    }
                    (is_visited, beginning) = (true, Beginning::Changed);
                }
            }
            if let Some(reason) = stop {
                return Ok(reason);
            }
        }
    }

    /// The reactions to events of one time, in the order of their indices, and the state at that time of the stepper.
    fn react<S: Scalar, D: Dynamics<S> + ?Sized>(
        &mut self,
        system: &mut impl React<S, D>,
        stepper: &mut I::Stepper,
        occurring: Occurring,
    ) -> (Reaction, D::State)
    where
        I: Integrator<S, D>,
        C: StopCondition<S, D>,
    {
        let step = stepper.time() - stepper.previous_time();
        let At { t, mut x } = LastStep::new(system.dynamics(), stepper).at(occurring.t);
        let here = S::from_f64(t);
        let mut all = Reaction::Unchanged;
        for event in occurring.events.indices() {
            let dynamics = system.dynamics();
            let located = Located {
                dynamics,
                t,
                x: &x,
                step,
            };
            let delay = located.delay(&mut self.condition, event);
            let before = moved(dynamics, here, &x, delay);
            let mut there = before.clone();
            match system.react(event, here + delay, &mut there) {
                Reaction::Unchanged if !differs(&before, &there) => {}
                Reaction::Unchanged | Reaction::Changed => {
                    all = Reaction::Changed;
                    x = moved(system.dynamics(), here + delay, &there, -delay);
                }
                Reaction::Stop => return (Reaction::Stop, there),
            }
        }
        (all, x)
    }

    /// Begins anew from the state that a reaction has left. The events that occur again and again in too short a time.
    fn begin_anew<S: Scalar, D: Dynamics<S> + ?Sized>(
        &mut self,
        dynamics: &D,
        stepper: &mut I::Stepper,
        memory: &mut C::Memory,
        occurring: Occurring,
        x: &D::State,
    ) -> Result<MetConditions, IntegrationError>
    where
        I: Integrator<S, D>,
        C: StopCondition<S, D>,
    {
        let step = stepper.time() - stepper.previous_time();
        let (t, x) = (occurring.t, x.clone());
        self.check_state(dynamics, &At { t, x: x.clone() })?;
        stepper.restart_at(dynamics, t, x.clone())?;
        let condition = &mut self.condition;
        Ok(condition.restart(memory, dynamics, occurring, &x, step))
    }

    /// Checks the settings and the initial value. The singularity comes before the derivative: where M is
    /// singular, the accelerations are not finite, and an error about them would say less.
    pub(crate) fn begin<S: Scalar, D: Dynamics<S> + ?Sized>(
        &self,
        dynamics: &D,
        initial: &At<f64, D::State>,
    ) -> Result<I::Stepper, IntegrationError>
    where
        I: Integrator<S, D>,
        C: StopCondition<S, D>,
    {
        self.check_state(dynamics, initial)?;
        self.integrator
            .start(dynamics, initial.t, initial.x.clone())
    }

    /// An error unless the settings are valid and the state is finite and regular.
    pub(crate) fn check_state<S: Scalar, D: Dynamics<S> + ?Sized>(
        &self,
        dynamics: &D,
        initial: &At<f64, D::State>,
    ) -> Result<(), IntegrationError>
    where
        I: Integrator<S, D>,
        C: StopCondition<S, D>,
    {
        self.condition.check(dynamics)?;
        if let Some(tolerance) = self
            .singularity_tolerance
            .filter(|&tolerance| tolerance.is_nan() || tolerance <= 0.0)
        {
            return Err(IntegrationError::InvalidSingularityTolerance { tolerance });
        }
        checked_state(dynamics, initial.t, &initial.x)?;
        check_singularity::<S, D>(dynamics, initial.t, &initial.x, self.min_pivot::<S, D>())
    }

    /// The smallest relative pivot that does not end the integration.
    fn min_pivot<S: Scalar, D: Dynamics<S> + ?Sized>(&self) -> f64
    where
        I: Integrator<S, D>,
    {
        let epsilon = S::machine_epsilon();
        let allowed = self.singularity_tolerance.unwrap_or_else(|| {
            self.integrator
                .singularity_tolerance()
                .max(MIN_SINGULARITY_TOLERANCE * epsilon)
        });
        epsilon / allowed
    }
}

/// Updates the state, if it is time to, and tells when the next update is, if the motion comes there: updates are of a motion
/// forwards in time.
fn update<S: Scalar, D: Dynamics<S> + ?Sized>(
    dynamics: &D,
    stepper: &mut impl Advance<S, D>,
    end: f64,
) -> Result<Option<f64>, IntegrationError> {
    let t = stepper.time();
    let Some(mut next) = dynamics.next_update(stepper.state()) else {
        return Ok(None);
    };
    if next <= t && t <= end {
        let mut x = stepper.state().clone();
        dynamics.update(S::from_f64(t), &mut x);
        next = dynamics.next_update(&x).unwrap_or(f64::INFINITY);
        checked_state(dynamics, t, &x)?;
        stepper.restart_at(dynamics, t, x)?;
    }
    if next > t || t > end {
        Ok(Some(next).filter(|next| *next < end))
    } else {
        Err(IntegrationError::InvalidUpdate { time: t, next })
    }
}

/// An error unless the times are finite and advance in the direction from `start` to the last.
pub(crate) fn check_times(start: f64, times: &[f64]) -> Result<(), IntegrationError> {
    if let Some(&time) = times.iter().find(|time| !time.is_finite()) {
        return Err(IntegrationError::NonFiniteTime { time });
    }
    let backwards = times.last().is_some_and(|&end| end < start);
    let mut previous = start;
    for (index, &time) in times.iter().enumerate() {
        if (time < previous && !backwards) || (time > previous && backwards) {
            return Err(IntegrationError::UnorderedTimes {
                index,
                time,
                previous,
            });
        }
        previous = time;
    }
    Ok(())
}
