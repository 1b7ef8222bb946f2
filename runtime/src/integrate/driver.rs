//! The driver of an integration: the checks before the first step, and the loop over steps and reactions.

use super::at::At;
use super::collector::Collector;
use super::dynamics::Dynamics;
use super::error::IntegrationError;
use super::event::{Detection, LastStep, Located, MetConditions, Occurring, differs, moved};
use super::integration::Integration;
use super::integrator::Integrator;
use super::loop_state::{Beginning, Interruption, LoopState, Steps};
use super::observer::Observer;
use super::outcome::{Outcome, StopReason};
use super::reactions::Reactions;
use super::sample_times::SampleTimes;
use super::stepper::{Advance, Stepper as _, checked_state};
use crate::limits::MIN_SINGULARITY_TOLERANCE;
use crate::scalar::Scalar;

/// A method, what is watched, and limits. It takes steps until there is a reason to stop.
#[derive(Clone, Debug)]
pub(crate) struct Driver<I, C, O> {
    pub(crate) integrator: I,
    pub(crate) conditions: C,
    pub(crate) observer: O,
    pub(crate) singularity_tolerance: Option<f64>,
}

/// The end and the step limit of an integration that continues from its present state.
#[derive(Clone, Copy)]
pub(crate) struct Course {
    pub(crate) end: f64,
    /// The largest number of steps, rejected ones included.
    pub(crate) max_steps: u64,
}

impl Course {
    /// Returns an error unless the end is finite.
    pub(crate) fn check(self) -> Result<(), IntegrationError> {
        let time = self.end;
        if time.is_finite() {
            Ok(())
        } else {
            Err(IntegrationError::NonFiniteTime { time })
        }
    }
}

/// What an integration does next.
pub(crate) enum Next {
    End(StopReason),
    /// Takes a step towards this time; the caller takes it.
    Step(f64),
}

/// The effect of the reactions to events.
struct Reacted<X> {
    /// The state, if it or the dynamics have changed.
    changed: Option<X>,
    /// The reason for which the integration ends, and the events that caused it.
    stop: Option<(StopReason, MetConditions)>,
}

impl<I, C, O> Driver<I, C, O> {
    /// Continues along a course that has been checked.
    pub(crate) fn advance<S: Scalar, D: Dynamics<S>, R: Reactions<S, D>>(
        &mut self,
        system: (&mut D, &mut R),
        (stepper, memory, samples): (
            &mut I::Stepper,
            &mut Option<C::Memory>,
            &mut dyn SampleTimes,
        ),
        course: Course,
        collector: &mut dyn Collector<S, D, I::Stepper>,
    ) -> (Outcome<D::State>, Result<(), IntegrationError>)
    where
        I: Integrator<S, D>,
        C: Detection<S, D>,
        O: Observer<D::State>,
    {
        let (mut state, mut outcome) = self.set_out::<S, D>(stepper, course);
        let begun = memory.take();
        let mut known = begun.unwrap_or_else(|| {
            self.conditions
                .begin(system.0, state.start, &outcome.last.x)
        });
        let parts = (&mut *stepper, &mut known, samples);
        let way = (&mut state, Steps::Own);
        let result = self.go_on(system, parts, way, collector, &mut outcome);
        *memory = Some(known);
        let result = result.map(|next| {
            if let Next::End(reason) = next {
                outcome.reason = reason;
            }
        });
        (outcome, result)
    }

    /// Returns the state of the loop before its first step.
    pub(crate) fn set_out<S: Scalar, D: Dynamics<S>>(
        &self,
        stepper: &I::Stepper,
        course: Course,
    ) -> (LoopState, Outcome<D::State>)
    where
        I: Integrator<S, D>,
    {
        let (t, x) = (stepper.time(), stepper.state().clone());
        let attempts = stepper.statistics().attempts();
        let state = LoopState {
            start: t,
            end: course.end,
            min_pivot: self.min_pivot::<S, D>(),
            step_limit: attempts.saturating_add(course.max_steps),
            update: None,
            beginning: Beginning::Initial,
            is_visited: true,
        };
        (state, Outcome::at(At { t, x }))
    }

    /// Integrates part after part, with a reaction between them, until the integration ends or the caller is to take a
    /// step.
    pub(crate) fn go_on<S: Scalar, D: Dynamics<S>, R: Reactions<S, D>>(
        &mut self,
        (dynamics, reactions): (&mut D, &mut R),
        (stepper, memory, samples): (&mut I::Stepper, &mut C::Memory, &mut dyn SampleTimes),
        (state, steps): (&mut LoopState, Steps),
        collector: &mut dyn Collector<S, D, I::Stepper>,
        outcome: &mut Outcome<D::State>,
    ) -> Result<Next, IntegrationError>
    where
        I: Integrator<S, D>,
        C: Detection<S, D>,
        O: Observer<D::State>,
    {
        loop {
            if !matches!(state.beginning, Beginning::Stepped(_)) {
                state.update = update(dynamics, stepper, state.end)?;
            }
            let mut part = Integration {
                dynamics: &*dynamics,
                stepper: &mut *stepper,
                waiting: &mut *samples,
                condition: &mut self.conditions,
                memory: &mut *memory,
                state: *state,
                steps,
                reacts: R::REACTS,
                pending: None,
                failure: None,
                observer: &mut self.observer,
                collector: &mut *collector,
                outcome: &mut *outcome,
            };
            let begun = part.begin();
            let completed = part.complete(begun);
            let interruption = completed.map(|interruption| part.finish(interruption));
            *state = part.state;
            let (occurring, stop) = match interruption? {
                Interruption::Stop(reason) => return Ok(Next::End(reason)),
                Interruption::Step(target) => return Ok(Next::Step(target)),
                // A constant, so that programs without reactions contain no code for them.
                Interruption::Reaction(_, stop) if !R::REACTS => {
                    return Ok(Next::End(stop.unwrap_or(StopReason::Condition)));
                }
                Interruption::Reaction(occurring, stop) => (occurring, stop),
                Interruption::Update => {
                    (state.is_visited, state.beginning) = (true, Beginning::Unchanged);
                    continue;
                }
            };
            let parts = (&mut *stepper, &mut *memory);
            let reacted = self.react((&mut *dynamics, &mut *reactions), parts, occurring)?;
            if let Some(x) = &reacted.changed {
                outcome.last.x = x.clone();
                (state.is_visited, state.beginning) = (true, Beginning::Changed);
            } else {
                state.beginning = Beginning::Unchanged;
            }
            if let Some(reason) = stop {
                return Ok(Next::End(reason));
            }
            if let Some((reason, met)) = reacted.stop {
                outcome.met = met;
                return Ok(Next::End(reason));
            }
        }
    }

    /// Runs the reactions to all events at one time, in the order of their indices. If they change the state or the
    /// dynamics, the method restarts.
    fn react<S: Scalar, D: Dynamics<S>, R: Reactions<S, D>>(
        &mut self,
        (dynamics, reactions): (&mut D, &mut R),
        (stepper, memory): (&mut I::Stepper, &mut C::Memory),
        occurring: Occurring,
    ) -> Result<Reacted<D::State>, IntegrationError>
    where
        I: Integrator<S, D>,
        C: Detection<S, D>,
    {
        let step = stepper.time() - stepper.previous_time();
        let At { t, mut x } = LastStep::new(&*dynamics, stepper).at(occurring.t);
        let here = S::from_f64(t);
        let (mut changes, mut stops) = (false, false);
        for event in occurring.events.indices() {
            let located = Located {
                dynamics: &*dynamics,
                t,
                x: &x,
                step,
            };
            let delay = located.delay(&mut self.conditions, event);
            let before = moved(&*dynamics, here, &x, delay);
            let mut there = before.clone();
            let reaction = reactions.react(event, here + delay, &mut there, dynamics);
            stops |= reaction.stops;
            if reaction.changes || differs(&before, &there) {
                changes = true;
                x = moved(&*dynamics, here + delay, &there, -delay);
            }
        }
        let mut stop = stops.then_some((StopReason::Condition, occurring.events));
        if changes {
            let zeno = self.begin_anew(dynamics, stepper, memory, occurring, &x)?;
            stop = stop.or(zeno.any().then_some((StopReason::Zeno, zeno)));
        }
        Ok(Reacted {
            changed: changes.then_some(x),
            stop,
        })
    }

    /// Restarts from the state that a reaction has left. Returns the events that recur in too short a time.
    fn begin_anew<S: Scalar, D: Dynamics<S>>(
        &mut self,
        dynamics: &mut D,
        stepper: &mut I::Stepper,
        memory: &mut C::Memory,
        occurring: Occurring,
        x: &D::State,
    ) -> Result<MetConditions, IntegrationError>
    where
        I: Integrator<S, D>,
        C: Detection<S, D>,
    {
        let step = stepper.time() - stepper.previous_time();
        let (t, x) = (occurring.t, x.clone());
        dynamics.begin(S::from_f64(t), &x);
        self.check_state(dynamics, &At { t, x: x.clone() })?;
        stepper.restart_at(dynamics, t, x.clone())?;
        let condition = &mut self.conditions;
        Ok(condition.restart(memory, dynamics, occurring, &x, step))
    }

    /// Checks the settings and the initial value. The singularity is checked before the derivative: where M is
    /// singular, the accelerations are not finite, and an error about them would be less informative.
    pub(crate) fn begin<S: Scalar, D: Dynamics<S>>(
        &self,
        dynamics: &D,
        initial: &At<f64, D::State>,
    ) -> Result<I::Stepper, IntegrationError>
    where
        I: Integrator<S, D>,
        C: Detection<S, D>,
    {
        self.check_state(dynamics, initial)?;
        self.integrator
            .start(dynamics, initial.t, initial.x.clone())
    }

    /// Returns an error unless the settings are valid and the state is finite and regular.
    pub(crate) fn check_state<S: Scalar, D: Dynamics<S>>(
        &self,
        dynamics: &D,
        initial: &At<f64, D::State>,
    ) -> Result<(), IntegrationError>
    where
        I: Integrator<S, D>,
        C: Detection<S, D>,
    {
        dynamics.check()?;
        self.conditions.check(dynamics)?;
        if let Some(tolerance) = self
            .singularity_tolerance
            .filter(|&tolerance| tolerance.is_nan() || tolerance <= 0.0)
        {
            return Err(IntegrationError::InvalidSingularityTolerance { tolerance });
        }
        let At { t, x } = initial;
        checked_state(dynamics, *t, x)?;
        let min_pivot = Some(self.min_pivot::<S, D>()).filter(|pivot| *pivot > 0.0);
        let found = min_pivot.and_then(|pivot| dynamics.singularity(S::from_f64(*t), x, pivot));
        found.map_or(Ok(()), |found| {
            Err(IntegrationError::singular::<S>(*t, found))
        })
    }

    /// Returns the smallest relative pivot that does not end the integration.
    fn min_pivot<S: Scalar, D: Dynamics<S>>(&self) -> f64
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

/// Updates the state if an update is due, and returns the time of the next update if it is before the end. Updates
/// happen only in motions forwards in time.
fn update<S: Scalar, D: Dynamics<S>>(
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
