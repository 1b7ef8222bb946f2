//! Who watches a motion.

use core::ops::ControlFlow;

use super::stepper::Statistics;

/// What a [`Driver`](crate::Driver) shows every sample and the end of every step: a closure that
/// takes a [`Progress`], or a type of one's own.
pub trait Observer<X> {
    /// Looks at the motion, and stops it by [`ControlFlow::Break`].
    fn observe(&mut self, progress: &Progress<'_, X>) -> ControlFlow<()>;
}

impl<X, F: FnMut(&Progress<'_, X>) -> ControlFlow<()>> Observer<X> for F {
    fn observe(&mut self, progress: &Progress<'_, X>) -> ControlFlow<()> {
        self(progress)
    }
}

/// No observer.
#[derive(Clone, Copy, Debug, Default)]
pub struct Unobserved;

impl<X> Observer<X> for Unobserved {
    #[inline]
    fn observe(&mut self, _: &Progress<'_, X>) -> ControlFlow<()> {
        ControlFlow::Continue(())
    }
}

/// What there is to see.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ObservationKind {
    /// One of the times asked for. The samples within a step are shown before its end is.
    Sample,
    /// The end of a step.
    Step,
}

/// How far a motion has come.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Progress<'a, X> {
    /// What there is to see.
    pub kind: ObservationKind,
    /// The time.
    pub t: f64,
    /// The state at that time.
    pub x: &'a X,
    /// The time at which the motion began.
    pub start: f64,
    /// The time at which it is to end.
    pub end: f64,
    /// What it has cost.
    pub statistics: Statistics,
}

impl<X> Progress<'_, X> {
    /// The part of the way that is done, from 0 to 1.
    #[must_use]
    pub fn fraction(&self) -> f64 {
        let whole = self.end - self.start;
        if whole == 0.0 {
            1.0
        } else {
            (self.t - self.start) / whole
        }
    }
}
