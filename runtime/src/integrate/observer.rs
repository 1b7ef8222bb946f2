//! Observers of an integration.

use core::ops::ControlFlow;

use super::event::MetConditions;
use super::stepper::Statistics;

/// Functions that are called on the way.
pub trait Observer<X> {
    /// How many there are.
    const COUNT: usize;

    /// Calls each, and returns those that stop the integration.
    fn observe(&mut self, progress: &Progress<'_, X>) -> MetConditions;
}

/// What a function that is called on the way returns: nothing, or whether the integration goes on.
#[diagnostic::on_unimplemented(
    message = "`{Self}` does not tell whether an integration goes on",
    note = "return nothing, or `ControlFlow::Break(())` where it is to end"
)]
pub trait Flow {
    /// Whether it goes on.
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

/// What an observer is called for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ObservationKind {
    /// One of the sample times. The samples within a step come before its end.
    Sample,
    /// The end of a step, or of the part of it that counts: up to where the integration stops, or where a reaction has
    /// changed the state, which is then the changed one.
    Step,
    /// An event, of that index. The state is the one before any reaction.
    Event(usize),
}

/// The progress of an integration.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Progress<'a, X> {
    /// What the observer is called for.
    pub kind: ObservationKind,
    /// The time.
    pub t: f64,
    /// The state at that time.
    pub x: &'a X,
    /// The initial time.
    pub start: f64,
    /// The final time.
    pub end: f64,
    /// The cost so far.
    pub statistics: Statistics,
}

impl<X> Progress<'_, X> {
    /// The fraction of the time interval that is done, from 0 to 1.
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
