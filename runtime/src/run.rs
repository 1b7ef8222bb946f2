//! An integration under way: the loop of the driver.

use core::{marker::PhantomData, ops::ControlFlow};

use crate::{
    Condition, Dynamics, Ending, IntegrationError, Observer, Occasion, Progress, Reason, Sample,
    Scalar, Stepper,
};

/// An integration under way.
pub(crate) struct Run<'a, S: Scalar, D: Dynamics<S> + ?Sized, T, C, O> {
    pub(crate) dynamics: &'a D,
    pub(crate) stepper: T,
    pub(crate) start: f64,
    pub(crate) end: f64,
    /// The sample times that have not been visited.
    pub(crate) waiting: &'a [f64],
    pub(crate) least_pivot: f64,
    pub(crate) maximal_steps: u64,
    pub(crate) condition: &'a mut C,
    pub(crate) observer: &'a mut O,
    pub(crate) collect: &'a mut dyn FnMut(&Sample<D::State>),
    /// Kept up to date, so that it is right however the run ends.
    pub(crate) ending: &'a mut Ending<D::State>,
    pub(crate) scalar: PhantomData<S>,
}

impl<S, D, T, C, O> Run<'_, S, D, T, C, O>
where
    S: Scalar,
    D: Dynamics<S> + ?Sized,
    T: Stepper<S, D::State>,
    C: Condition<D::State>,
    O: Observer<D::State>,
{
    /// Goes on until there is a reason to end, which is in `ending` afterwards.
    pub(crate) fn complete(&mut self) -> Result<(), IntegrationError> {
        self.ending.statistics = self.stepper.statistics();
        let mut value = self.condition.value(self.start, self.stepper.state());
        let mut reason = self.samples_until(self.start).err();
        if reason.is_none() && self.condition.met(value, value) {
            reason = Some(Reason::Condition);
        }
        while reason.is_none() && self.stepper.time() - self.end != 0.0 {
            self.step()?;
            self.check_regular()?;
            let before = value;
            value = self
                .condition
                .value(self.stepper.time(), self.stepper.state());
            reason = self.visit_step(before, value).err();
        }
        self.ending.statistics = self.stepper.statistics();
        self.ending.reason = reason.unwrap_or(Reason::Completed);
        Ok(())
    }

    /// Takes one step.
    fn step(&mut self) -> Result<(), IntegrationError> {
        let statistics = self.stepper.statistics();
        if statistics.steps.saturating_add(statistics.rejected) >= self.maximal_steps {
            return Err(IntegrationError::TooManySteps {
                time: self.stepper.time(),
                limit: self.maximal_steps,
            });
        }
        let next = if T::DENSE { None } else { self.waiting.first() };
        let target = next.copied().unwrap_or(self.end);
        let result = self.stepper.step(self.dynamics, target);
        self.ending.statistics = self.stepper.statistics();
        result
    }

    /// An error if the state that was reached is too near to a singularity. The samples before it are
    /// visited.
    fn check_regular(&mut self) -> Result<(), IntegrationError> {
        let (t, x) = (self.stepper.time(), self.stepper.state());
        let result = check_singularity(self.dynamics, t, x, self.least_pivot);
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

    /// Samples, condition and observer for the step just taken; the reason to end, if there is one.
    fn visit_step(&mut self, before: f64, after: f64) -> Result<(), Reason> {
        let met = self.condition.met(before, after);
        if met && C::LOCATED {
            let stop = self.locate(before, after);
            self.samples_until(stop.t)?;
            self.ending.last = stop;
            self.show(Occasion::Step)?;
            return Err(Reason::Condition);
        }
        self.samples_until(self.stepper.time())?;
        self.ending.last = Sample {
            t: self.stepper.time(),
            x: self.stepper.state().clone(),
        };
        self.show(Occasion::Step)?;
        if met { Err(Reason::Condition) } else { Ok(()) }
    }

    /// Visits the sample times up to `t` within the last step.
    fn samples_until(&mut self, t: f64) -> Result<(), Reason> {
        let forwards = self.end >= self.start;
        while let Some((&time, rest)) = self.waiting.split_first() {
            if (forwards && time > t) || (!forwards && time < t) {
                break;
            }
            self.waiting = rest;
            self.ending.last = self.at(time);
            (self.collect)(&self.ending.last);
            self.show(Occasion::Sample)?;
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

    /// Where in the last step the condition's value, `before` at its start, changes its sign.
    fn locate(&mut self, before: f64, after: f64) -> Sample<D::State> {
        let mut there = Sample {
            t: self.stepper.time(),
            x: self.stepper.state().clone(),
        };
        let mut here = self.stepper.previous_time();
        if after == 0.0 {
            return there;
        }
        // A step has fewer than 2⁶⁴ numbers between its ends unless one of them is near zero.
        for _ in 0..64 {
            let middle = here + 0.5 * (there.t - here);
            if middle.to_bits() == here.to_bits() || middle.to_bits() == there.t.to_bits() {
                break;
            }
            let sample = self.at(middle);
            let value = self.condition.value(middle, &sample.x);
            if self.condition.met(before, value) {
                there = sample;
            } else {
                here = middle;
            }
        }
        there
    }

    fn show(&mut self, occasion: Occasion) -> Result<(), Reason> {
        let progress = Progress {
            occasion,
            t: self.ending.last.t,
            x: &self.ending.last.x,
            start: self.start,
            end: self.end,
            statistics: self.stepper.statistics(),
        };
        match self.observer.observe(&progress) {
            ControlFlow::Continue(()) => Ok(()),
            ControlFlow::Break(()) => Err(Reason::Observer),
        }
    }
}

/// An error where a relative pivot is below the least allowed one.
pub(crate) fn check_singularity<S: Scalar, D: Dynamics<S> + ?Sized>(
    dynamics: &D,
    t: f64,
    x: &D::State,
    least_pivot: f64,
) -> Result<(), IntegrationError> {
    if least_pivot <= 0.0 {
        return Ok(());
    }
    match dynamics.singularity(S::from_f64(t), x, least_pivot) {
        None => Ok(()),
        Some(singularity) => Err(IntegrationError::SingularConfiguration {
            time: t,
            estimated_loss: S::machine_epsilon() / singularity.relative_pivot(),
            singularity,
        }),
    }
}
