//! The loop of the driver: steps, samples, observations, and the location of stop conditions within a step.
//!
//! A change of sign of an event function over a step is located by bisection of the interpolated state. L. F. Shampine
//! & S. Thompson, *Event Location for Ordinary Differential Equations*, Comput. Math. Appl. **39** (2000) 43–54, show
//! that the error of an integration which restarts there is of the order of the method. A zero at the initial time is
//! left as by K. L. Hiebert & L. F. Shampine, *Implicitly Defined Output Points for Solutions of ODEs*, SAND80-0180
//! (1980).

use core::{marker::PhantomData, ops::ControlFlow};

use super::collector::Collector;
use super::dynamics::Dynamics;
use super::error::IntegrationError;
use super::observer::{ObservationKind, Observer, Progress};
use super::outcome::{Outcome, StopReason};
use super::sample::Sample;
use super::stepper::Advance;
use super::stop_condition::{MetConditions, StopCondition};
use crate::limits::events::{BISECTIONS, DEPARTURE_GROWTH, TIME_RESOLUTION};
use crate::scalar::Scalar;

/// An integration in progress.
pub(crate) struct Integration<'a, S: Scalar, D: Dynamics<S> + ?Sized, T, C, O> {
    pub(crate) dynamics: &'a D,
    pub(crate) stepper: &'a mut T,
    pub(crate) start: f64,
    pub(crate) end: f64,
    /// The sample times that are left.
    pub(crate) waiting: &'a [f64],
    pub(crate) min_pivot: f64,
    /// The number of steps, rejected ones included, at which to stop.
    pub(crate) step_limit: u64,
    pub(crate) condition: &'a mut C,
    /// Within the first step, the time up to which the condition has been evaluated.
    pub(crate) evaluated_until: Option<f64>,
    pub(crate) observer: &'a mut O,
    pub(crate) collector: &'a mut dyn Collector<S, D, T>,
    /// Up to date at any time, so that it is valid after an error, too.
    pub(crate) outcome: &'a mut Outcome<D::State>,
    pub(crate) scalar: PhantomData<S>,
}

impl<S, D, T, C, O> Integration<'_, S, D, T, C, O>
where
    S: Scalar,
    D: Dynamics<S> + ?Sized,
    T: Advance<S, D>,
    C: StopCondition<D::State>,
    O: Observer<D::State>,
{
    /// Steps until there is a reason to stop, and stores it in `outcome`.
    pub(crate) fn complete(&mut self) -> Result<(), IntegrationError> {
        self.outcome.statistics = self.stepper.statistics();
        let mut value = self.condition.value(self.start, self.stepper.state());
        let mut reason = self.samples_until(self.start).err();
        let met = self.condition.met(value, value);
        if reason.is_none() && met.any() {
            self.outcome.met = met;
            reason = Some(StopReason::Condition);
        }
        let mut at_start = C::LOCATED;
        while reason.is_none() && self.stepper.time() - self.end != 0.0 {
            if self.step_limit_is_reached() {
                reason = Some(StopReason::StepLimit);
                break;
            }
            self.step()?;
            self.check_regular()?;
            let mut visited = Ok(());
            if at_start {
                visited = self.leave_initial_time(&mut value);
                at_start = false;
            }
            reason = visited.and_then(|()| self.visit_step(&mut value)).err();
            self.evaluated_until = None;
        }
        self.outcome.statistics = self.stepper.statistics();
        self.outcome.reason = reason.unwrap_or(StopReason::Completed);
        Ok(())
    }

    fn step_limit_is_reached(&self) -> bool {
        self.stepper.statistics().attempts() >= self.step_limit
    }

    /// Takes one step.
    fn step(&mut self) -> Result<(), IntegrationError> {
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

    /// An error if the present state is too near to a singularity. The samples before it are collected first.
    fn check_regular(&mut self) -> Result<(), IntegrationError> {
        let (t, x) = (self.stepper.time(), self.stepper.state());
        let result = check_singularity(self.dynamics, t, x, self.min_pivot);
        if result.is_err() {
            let before = if self.end >= self.start {
                t.next_down()
            } else {
                t.next_up()
            };
            // The error takes precedence over a stop by the observer.
            let _ = self.samples_until(before);
        }
        result
    }

    /// The value of the condition at the first time that is distinguishable from the initial one. There may be a zero
    /// at the initial time, such as the one at which the integration stopped before, and rounding may put the initial
    /// value on either side of it.
    ///
    /// Hiebert & Shampine (1980); the time is that of SUNDIALS: A. C. Hindmarsh et al., ACM Trans. Math. Softw. **31**
    /// (2005) 363–396.
    fn leave_initial_time(&mut self, value: &mut C::Value) -> Result<(), StopReason> {
        let time_after = self.after(self.start);
        if time_after - self.stepper.time() == 0.0 {
            return Ok(());
        }
        let there = self.at(time_after);
        let after = self.condition.value(time_after, &there.x);
        let met = self.condition.met_after_start(*value, after);
        if met.any() {
            return self.stop(*value, there, met);
        }
        *value = self.condition.last_signed(*value, after);
        self.leave_zero(time_after, value)
    }

    /// Evaluates the condition at times each four times as far from the initial one, until it is not zero. A
    /// difference of nearly equal numbers, such as a height above a floor that is not at 0, is rounded to zero for a
    /// while, and a flight that ends within the first step must not be missed.
    fn leave_zero(&mut self, time_after: f64, value: &mut C::Value) -> Result<(), StopReason> {
        let (end, mut distance) = (self.stepper.time(), time_after - self.start);
        while !C::is_signed(*value) {
            distance *= DEPARTURE_GROWTH;
            let time_after = self.start + distance;
            if distance.abs() >= (end - self.start).abs() || time_after - self.start == 0.0 {
                break;
            }
            let there = self.at(time_after);
            let after = self.condition.value(time_after, &there.x);
            let met = self.condition.met(*value, after);
            if met.any() {
                return self.stop(*value, there, met);
            }
            *value = self.condition.last_signed(*value, after);
            self.evaluated_until = Some(time_after);
        }
        Ok(())
    }

    /// The first time after `t` within the last step that is safely distinguishable from it; at most
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

    /// Samples, condition and observer for the step just taken; the reason to stop, if there is one.
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
        *value = self.condition.last_signed(*value, after);
        self.samples_until(there.t)?;
        self.record_until(there.t);
        self.outcome.last = there;
        self.notify(ObservationKind::Step)?;
        if met.any() {
            self.outcome.met = met;
            return Err(StopReason::Condition);
        }
        Ok(())
    }

    /// Stops where the condition, whose value was `before` at some time in the last step, is first met, at the
    /// latest at `there`.
    fn stop(
        &mut self,
        before: C::Value,
        there: Sample<D::State>,
        met: MetConditions,
    ) -> Result<(), StopReason> {
        let (stop, met) = self.locate(before, there, met);
        // Conditions that are met within the resolution of time are met together.
        let time_after = self.after(stop.t);
        let next = self.at(time_after);
        let value = self.condition.value(time_after, &next.x);
        self.samples_until(stop.t)?;
        self.record_until(stop.t);
        self.outcome.last = stop;
        self.notify(ObservationKind::Step)?;
        self.outcome.met = met.or(self.condition.met(before, value));
        Err(StopReason::Condition)
    }

    /// Takes the samples up to `t` within the last step.
    fn samples_until(&mut self, t: f64) -> Result<(), StopReason> {
        let forwards = self.end >= self.start;
        while let Some((&time, rest)) = self.waiting.split_first() {
            if (forwards && time > t) || (!forwards && time < t) {
                break;
            }
            self.waiting = rest;
            self.outcome.last = self.at(time);
            self.collector.sample(&self.outcome.last);
            self.notify(ObservationKind::Sample)?;
        }
        Ok(())
    }

    /// Passes the last step to the collector, which is part of the motion until `end`.
    fn record_until(&mut self, end: f64) {
        self.collector.step(self.dynamics, self.stepper, end);
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

    /// Where in the last step the condition, whose value was `before`, is first met, by bisection, and which of its
    /// parts are.
    fn locate(
        &mut self,
        before: C::Value,
        mut there: Sample<D::State>,
        mut met: MetConditions,
    ) -> (Sample<D::State>, MetConditions) {
        let evaluated_until = self.evaluated_until.take();
        let mut here = evaluated_until.unwrap_or_else(|| self.stepper.previous_time());
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

    fn notify(&mut self, kind: ObservationKind) -> Result<(), StopReason> {
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

/// An error if a relative pivot is below `min_pivot`.
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
