//! Observers of an integration.

use core::ops::ControlFlow;
use core::sync::atomic::{AtomicBool, Ordering};

use super::event::MetConditions;
use super::stepper::Statistics;

/// What a [`Driver`](crate::Driver) calls at every sample, at every event and at the end of every step: a closure that
/// takes a [`Progress`], or a type of your own.
pub trait Observer<X> {
    /// Called with the present state; [`ControlFlow::Break`] stops the integration.
    fn observe(&mut self, progress: &Progress<'_, X>) -> ControlFlow<()>;

    /// Which of the observers that this one is made of stop the integration, in [`Outcome::met`](crate::Outcome::met).
    #[doc(hidden)]
    fn stopping(&mut self, progress: &Progress<'_, X>) -> MetConditions {
        MetConditions::of(core::iter::once(self.observe(progress).is_break()))
    }

    /// How many observers this one is made of.
    #[doc(hidden)]
    fn count(&self) -> usize {
        1
    }
}

impl<X, F: FnMut(&Progress<'_, X>) -> ControlFlow<()>> Observer<X> for F {
    fn observe(&mut self, progress: &Progress<'_, X>) -> ControlFlow<()> {
        self(progress)
    }
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
    fn observe(&mut self, progress: &Progress<'_, X>) -> ControlFlow<()> {
        (self.0)(progress).flow()
    }
}

/// Cancellation, from another thread too: the integration stops at the end of the step in which the flag becomes true.
///
/// ```
/// use core::sync::atomic::{AtomicBool, Ordering};
/// use lagrangian::prelude::*;
/// # use lagrangian::nalgebra::SVector;
/// # struct Oscillator;
/// # impl Dynamics for Oscillator {
/// #     type State = SVector<f64, 2>;
/// #     fn derivative(&self, _: f64, x: &Self::State) -> Self::State {
/// #         SVector::from([x[1], -x[0]])
/// #     }
/// # }
///
/// let cancelled = AtomicBool::new(false);
/// let outcome = std::thread::scope(|scope| {
///     scope.spawn(|| cancelled.store(true, Ordering::Relaxed));
///     let start = (0.0, SVector::from([1.0, 0.0]));
///     let driver = RungeKutta::classical(1e-9).driver().observe(&cancelled);
///     driver.run_until(&Oscillator, start, 1e6)
/// })?;
/// assert_eq!(outcome.reason, StopReason::Observer);
/// # Ok::<(), IntegrationError>(())
/// ```
///
/// An observer that does more asks the flag itself.
impl<X> Observer<X> for &AtomicBool {
    #[inline]
    fn observe(&mut self, _: &Progress<'_, X>) -> ControlFlow<()> {
        if self.load(Ordering::Relaxed) {
            ControlFlow::Break(())
        } else {
            ControlFlow::Continue(())
        }
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

    fn count(&self) -> usize {
        0
    }
}

/// The observers of a [`Driver`](crate::Driver), each of which is called; made by
/// [`Driver::observe`](crate::Driver::observe).
#[derive(Clone, Copy, Debug, Default)]
pub struct Observers<A, B>(pub(crate) A, pub(crate) B);

impl<X, A: Observer<X>, B: Observer<X>> Observer<X> for Observers<A, B> {
    #[inline]
    fn observe(&mut self, progress: &Progress<'_, X>) -> ControlFlow<()> {
        if self.stopping(progress).any() {
            ControlFlow::Break(())
        } else {
            ControlFlow::Continue(())
        }
    }

    #[inline]
    fn stopping(&mut self, progress: &Progress<'_, X>) -> MetConditions {
        let first = self.0.stopping(progress);
        first.or(self.1.stopping(progress).shifted(self.0.count()))
    }

    fn count(&self) -> usize {
        self.0.count() + self.1.count()
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
