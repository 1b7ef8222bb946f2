//! An integration under way: the loop of the driver.

use core::{marker::PhantomData, ops::ControlFlow};

use super::dynamics::Dynamics;
use super::error::IntegrationError;
use super::observer::{ObservationKind, Observer, Progress};
use super::outcome::{Outcome, StopReason};
use super::sample::Sample;
use super::stepper::Stepper;
use super::stop_condition::{MetConditions, StopCondition};
use crate::limits::events::{BISECTIONS, DEPARTURE_GROWTH, TIME_RESOLUTION};
use crate::scalar::Scalar;

/// An integration under way.
pub(crate) struct Integration<'a, S: Scalar, D: Dynamics<S> + ?Sized, T, C, O> {
    pub(crate) dynamics: &'a D,
    pub(crate) stepper: T,
    pub(crate) start: f64,
    pub(crate) end: f64,
    /// The sample times that have not been visited.
    pub(crate) waiting: &'a [f64],
    pub(crate) min_pivot: f64,
    pub(crate) max_steps: u64,
    pub(crate) condition: &'a mut C,
    /// Within the first step, until when the condition's value has been looked at.
    pub(crate) departure: Option<f64>,
    pub(crate) observer: &'a mut O,
    pub(crate) collect: &'a mut dyn FnMut(&Sample<D::State>),
    /// Kept up to date, so that it is right however the run ends.
    pub(crate) outcome: &'a mut Outcome<D::State>,
    pub(crate) scalar: PhantomData<S>,
}

impl<S, D, T, C, O> Integration<'_, S, D, T, C, O>
where
    S: Scalar,
    D: Dynamics<S> + ?Sized,
    T: Stepper<S, D::State>,
    C: StopCondition<D::State>,
    O: Observer<D::State>,
{
    /// Goes on until there is a reason to end, which is in `outcome` afterwards.
    pub(crate) fn complete(&mut self) -> Result<(), IntegrationError> {
        self.outcome.statistics = self.stepper.statistics();
        let mut value = self.condition.value(self.start, self.stepper.state());
        let mut reason = self.samples_until(self.start).err();
        let met = self.condition.met(value, value);
        if reason.is_none() && met.any() {
            self.outcome.met = met;
            reason = Some(StopReason::Condition);
        }
        let mut departing = C::LOCATED;
        while reason.is_none() && self.stepper.time() - self.end != 0.0 {
            self.step()?;
            self.check_regular()?;
            let mut visited = Ok(());
            if departing {
                visited = self.depart(&mut value);
                departing = false;
            }
            reason = visited.and_then(|()| self.visit_step(&mut value)).err();
            self.departure = None;
        }
        self.outcome.statistics = self.stepper.statistics();
        self.outcome.reason = reason.unwrap_or(StopReason::Completed);
        Ok(())
    }

    /// Takes one step.
    fn step(&mut self) -> Result<(), IntegrationError> {
        let statistics = self.stepper.statistics();
        if statistics.steps.saturating_add(statistics.rejected) >= self.max_steps {
            return Err(IntegrationError::TooManySteps {
                time: self.stepper.time(),
                limit: self.max_steps,
            });
        }
        let next = if T::DENSE_OUTPUT {
            None
        } else {
            self.waiting.first()
        };
        let target = next.copied().unwrap_or(self.end);
        let result = self.stepper.step(self.dynamics, target);
        self.outcome.statistics = self.stepper.statistics();
        result
    }

    /// An error if the state that was reached is too near to a singularity. The samples before it are
    /// visited.
    fn check_regular(&mut self) -> Result<(), IntegrationError> {
        let (t, x) = (self.stepper.time(), self.stepper.state());
        let result = check_singularity(self.dynamics, t, x, self.min_pivot);
        if result.is_err() {
            let before = if self.end >= self.start {
                t.next_down()
            } else {
                t.next_up()
            };
            // The error says more than why the observer may have wanted to stop.
            let _ = self.samples_until(before);
        }
        result
    }

    /// The condition's value at the first instant after the start that time resolves. The start may stand on a zero,
    /// such as one at which the motion was stopped before, and the sign there may be on either side of it.
    ///
    /// K. L. Hiebert & L. F. Shampine, *Implicitly Defined Output Points for Solutions of ODEs*, SAND80-0180 (1980);
    /// the instant is that of A. C. Hindmarsh et al., SUNDIALS, ACM TOMS **31** (2005) 363–396.
    fn depart(&mut self, value: &mut C::Value) -> Result<(), StopReason> {
        let instant = self.after(self.start);
        if instant - self.stepper.time() == 0.0 {
            return Ok(());
        }
        let there = self.at(instant);
        let after = self.condition.value(instant, &there.x);
        let met = self.condition.met_on_departure(*value, after);
        if met.any() {
            return self.stop(*value, there, met);
        }
        *value = self.condition.remembered(*value, after);
        self.leave(instant, value)
    }

    /// Looks on, at times four times as far from the start each, until the condition's value has left zero: what
    /// is small beside numbers in it, such as a height above a floor that is not at 0, is rounded to zero for a
    /// while, and a flight that ends within the first step is not to be missed.
    fn leave(&mut self, instant: f64, value: &mut C::Value) -> Result<(), StopReason> {
        let (end, mut distance) = (self.stepper.time(), instant - self.start);
        while !C::has_signs(*value) {
            distance *= DEPARTURE_GROWTH;
            let instant = self.start + distance;
            if distance.abs() >= (end - self.start).abs() || instant - self.start == 0.0 {
                break;
            }
            let there = self.at(instant);
            let after = self.condition.value(instant, &there.x);
            let met = self.condition.met(*value, after);
            if met.any() {
                return self.stop(*value, there, met);
            }
            *value = self.condition.remembered(*value, after);
            self.departure = Some(instant);
        }
        Ok(())
    }

    /// The first instant after a time within the last step that is told apart from it with certainty; at most
    /// the end of the step.
    fn after(&self, t: f64) -> f64 {
        let end = self.stepper.time();
        let step = end - self.stepper.previous_time();
        let resolution = TIME_RESOLUTION * f64::EPSILON * (t.abs() + step.abs());
        if resolution < (end - t).abs() {
            t + resolution.copysign(step)
        } else {
            end
        }
    }

    /// Samples, condition and observer for the step just taken; the reason to end, if there is one.
    fn visit_step(&mut self, value: &mut C::Value) -> Result<(), StopReason> {
        let there = Sample {
            t: self.stepper.time(),
            x: self.stepper.state().clone(),
        };
        let after = self.condition.value(there.t, &there.x);
        let met = self.condition.met(*value, after);
        if met.any() && C::LOCATED {
            return self.stop(*value, there, met);
        }
        *value = self.condition.remembered(*value, after);
        self.samples_until(there.t)?;
        self.outcome.last = there;
        self.show(ObservationKind::Step)?;
        if met.any() {
            self.outcome.met = met;
            return Err(StopReason::Condition);
        }
        Ok(())
    }

    /// Stops where the condition, whose value was `before` at some time in the last step, is first met; at the
    /// latest `there`.
    fn stop(
        &mut self,
        before: C::Value,
        there: Sample<D::State>,
        met: MetConditions,
    ) -> Result<(), StopReason> {
        let (stop, met) = self.locate(before, there, met);
        // What is met at the same time, as far as time tells, is met together.
        let instant = self.after(stop.t);
        let next = self.at(instant);
        let value = self.condition.value(instant, &next.x);
        self.samples_until(stop.t)?;
        self.outcome.last = stop;
        self.show(ObservationKind::Step)?;
        self.outcome.met = met.or(self.condition.met(before, value));
        Err(StopReason::Condition)
    }

    /// Visits the sample times up to `t` within the last step.
    fn samples_until(&mut self, t: f64) -> Result<(), StopReason> {
        let forwards = self.end >= self.start;
        while let Some((&time, rest)) = self.waiting.split_first() {
            if (forwards && time > t) || (!forwards && time < t) {
                break;
            }
            self.waiting = rest;
            self.outcome.last = self.at(time);
            (self.collect)(&self.outcome.last);
            self.show(ObservationKind::Sample)?;
        }
        Ok(())
    }

    /// The sample at a time within the last step.
    fn at(&mut self, t: f64) -> Sample<D::State> {
        let x = if t - self.stepper.time() == 0.0 {
            self.stepper.state().clone()
        } else {
            self.stepper.interpolate(self.dynamics, t)
        };
        Sample { t, x }
    }

    /// Where in the last step the condition, whose value was `before`, is first met, by bisection, and what of it.
    fn locate(
        &mut self,
        before: C::Value,
        mut there: Sample<D::State>,
        mut met: MetConditions,
    ) -> (Sample<D::State>, MetConditions) {
        let departure = self.departure.take();
        let mut here = departure.unwrap_or_else(|| self.stepper.previous_time());
        for _ in 0..BISECTIONS {
            let middle = here + 0.5 * (there.t - here);
            if middle.to_bits() == here.to_bits() || middle.to_bits() == there.t.to_bits() {
                break;
            }
            let sample = self.at(middle);
            let value = self.condition.value(middle, &sample.x);
            let found = self.condition.met(before, value);
            if found.any() {
                (there, met) = (sample, found);
            } else {
                here = middle;
            }
        }
        (there, met)
    }

    fn show(&mut self, kind: ObservationKind) -> Result<(), StopReason> {
        let progress = Progress {
            kind,
            t: self.outcome.last.t,
            x: &self.outcome.last.x,
            start: self.start,
            end: self.end,
            statistics: self.stepper.statistics(),
        };
        match self.observer.observe(&progress) {
            ControlFlow::Continue(()) => Ok(()),
            ControlFlow::Break(()) => Err(StopReason::Observer),
        }
    }
}

/// An error where a relative pivot is below the least allowed one.
pub(crate) fn check_singularity<S: Scalar, D: Dynamics<S> + ?Sized>(
    dynamics: &D,
    t: f64,
    x: &D::State,
    min_pivot: f64,
) -> Result<(), IntegrationError> {
    if min_pivot <= 0.0 {
        return Ok(());
    }
    match dynamics.singularity(S::from_f64(t), x, min_pivot) {
        None => Ok(()),
        Some(singularity) => Err(IntegrationError::SingularConfiguration {
            time: t,
            estimated_error: S::machine_epsilon() / singularity.relative_pivot(),
            singularity,
        }),
    }
}
