//! Observers of an integration.

use core::ops::ControlFlow;

use super::event::MetConditions;
use super::stepper::Statistics;

/// Functions that are called during an integration.
pub trait Observer<X> {
    /// The number of functions.
    const COUNT: usize;

    /// Calls each function, and returns those that stop the integration.
    fn observe(&mut self, progress: &Progress<'_, X>) -> MetConditions;
}

/// The return type of a function that is called during an integration: nothing, or whether the integration continues.
#[diagnostic::on_unimplemented(
    message = "`{Self}` does not tell whether an integration goes on",
    note = "return nothing, or `ControlFlow::Break(())` where it is to end"
)]
pub trait Flow {
    /// Returns whether the integration continues.
    fn flow(self) -> ControlFlow<()>;
}

impl Flow for () {
    fn flow(self) -> ControlFlow<()> {
        ControlFlow::Continue(())
    }
}

impl Flow for ControlFlow<()> {
    fn flow(self) -> Self {
        self
    }
}

/// A function that is called at each step.
#[derive(Clone, Copy, Debug)]
pub struct EachStep<F>(pub(super) F);

impl<X, A: Flow, F: FnMut(&Progress<'_, X>) -> A> Observer<X> for EachStep<F> {
    const COUNT: usize = 1;

    fn observe(&mut self, progress: &Progress<'_, X>) -> MetConditions {
        MetConditions::of(core::iter::once((self.0)(progress).flow().is_break()))
    }
}

impl<X> Observer<X> for () {
    const COUNT: usize = 0;

    #[inline]
    fn observe(&mut self, _: &Progress<'_, X>) -> MetConditions {
        MetConditions::default()
    }
}

impl<X, A: Observer<X>, B: Observer<X>> Observer<X> for (A, B) {
    const COUNT: usize = A::COUNT + B::COUNT;

    #[inline]
    fn observe(&mut self, progress: &Progress<'_, X>) -> MetConditions {
        let first = self.0.observe(progress);
        first.or(self.1.observe(progress).shifted(A::COUNT))
    }
}

/// The occasion on which an observer is called.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ObservationKind {
    /// One of the sample times. Samples within a step are observed before its end.
    Sample,
    /// The end of a step, or of the part of it that is used: up to the time at which the integration stops, or at which
    /// a reaction has changed the state. In the latter case, the state is the changed one.
    Step,
    /// The event with this index. The state is the one before any reaction.
    Event(usize),
}

/// The progress of an integration.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Progress<'a, X> {
    /// The occasion on which the observer is called.
    pub kind: ObservationKind,
    /// The time.
    pub t: f64,
    /// The state at that time.
    pub x: &'a X,
    /// The initial time.
    pub start: f64,
    /// The final time.
    pub end: f64,
    /// The statistics so far.
    pub statistics: Statistics,
}

impl<X> Progress<'_, X> {
    /// Returns the fraction of the time interval that is done, from 0 to 1.
    #[must_use]
    pub fn fraction(&self) -> f64 {
        let interval = self.end - self.start;
        if interval == 0.0 {
            1.0
        } else {
            (self.t - self.start) / interval
        }
    }
}
