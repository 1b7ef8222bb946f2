//! Solutions of problems.

#[cfg(feature = "alloc")]
use alloc::vec::Vec;
use core::fmt;
use core::ops::Deref;

use crate::integrate::at::At;
#[cfg(feature = "alloc")]
use crate::integrate::dense_solution::KeptMotion;
#[cfg(feature = "alloc")]
use crate::integrate::error::IntegrationError;
use crate::integrate::event::MetConditions;
#[cfg(feature = "alloc")]
use crate::integrate::event::Occurrence;
use crate::integrate::outcome::{Outcome, StopReason};
use crate::integrate::partial::Partial;
use crate::integrate::stepper::Statistics;
use crate::number_format::Readable;
use crate::scalar::Scalar;

/// The result of an integration. It dereferences to its last state: `solution.t`, `solution.q[0]`.
///
/// What else was kept depends on [`Problem::save`](crate::Problem::save): [`samples`](Self::samples), or the motion
/// [`at`](Self::at) any time.
#[derive(Clone, Debug, PartialEq)]
pub struct Solution<S, X, K = ()> {
    /// The last state: at the end, or where an event, a condition or an observer stopped the integration.
    pub last: At<S, X>,
    /// The reason for which the integration ended there.
    pub reason: StopReason,
    /// The conditions, events or observers that stopped it, numbered in the order in which they were set.
    pub met: MetConditions,
    /// The cost of the integration.
    pub statistics: Statistics,
    #[cfg_attr(not(feature = "alloc"), allow(dead_code))]
    events: Events<S, X>,
    kept: K,
}

/// The return type of an integration.
pub(crate) type Found<S, X, K> = Result<Solution<S, X, K>, Partial<Solution<S, X, K>>>;

/// The events that occurred; empty without an allocator.
#[cfg(feature = "alloc")]
pub(crate) type Events<S, X> = Vec<Occurrence<X, S>>;
#[cfg(not(feature = "alloc"))]
pub(crate) type Events<S, X> = core::marker::PhantomData<(X, S)>;

impl<S: Scalar, X, K> Solution<S, X, K> {
    pub(crate) fn new(
        kept: K,
        events: Events<S, X>,
        outcome: Outcome<X>,
        statistics: Statistics,
    ) -> Self {
        Self {
            last: outcome.last.on_scalar(),
            reason: outcome.reason,
            met: outcome.met,
            statistics,
            events,
            kept,
        }
    }
}

impl<S, X, K> Deref for Solution<S, X, K> {
    type Target = At<S, X>;

    fn deref(&self) -> &At<S, X> {
        &self.last
    }
}

#[cfg(feature = "alloc")]
impl<S, X, K> Solution<S, X, K> {
    /// Returns the events that occurred, in the order of time, including the events at which the integration stopped.
    #[must_use]
    pub fn events(&self) -> &[Occurrence<X, S>] {
        &self.events
    }
}

#[cfg(feature = "alloc")]
impl<S, X> IntoIterator for Solution<S, X, Vec<At<S, X>>> {
    type Item = At<S, X>;
    type IntoIter = alloc::vec::IntoIter<At<S, X>>;

    /// Iterates over the samples.
    fn into_iter(self) -> Self::IntoIter {
        self.kept.into_iter()
    }
}

#[cfg(feature = "alloc")]
impl<S: Scalar, X, K> Solution<S, X, K> {
    /// Returns the samples, in the order of time.
    #[must_use]
    pub fn samples(&self) -> &[At<S, X>]
    where
        K: KeptSamples<S, X>,
    {
        self.kept.samples()
    }

    /// Returns the state at a time between the start and the last state; at a jump, the state after it.
    ///
    /// # Errors
    ///
    /// [`OutsideSolution`](IntegrationError::OutsideSolution).
    pub fn at(&self, t: f64) -> Result<At<S, X>, IntegrationError>
    where
        K: KeptMotion<S, X>,
    {
        let (x, t) = (self.kept.state(t)?, S::from_f64(t));
        Ok(At { t, x })
    }

    /// Returns the state at a time; at a jump, the state before it.
    ///
    /// # Errors
    ///
    /// [`OutsideSolution`](IntegrationError::OutsideSolution).
    pub fn before(&self, t: f64) -> Result<At<S, X>, IntegrationError>
    where
        K: KeptMotion<S, X>,
    {
        let (x, t) = (self.kept.state_before(t)?, S::from_f64(t));
        Ok(At { t, x })
    }

    /// Returns the derivative of the state at a time, from the polynomial of the step; `None` if no step was taken.
    ///
    /// # Errors
    ///
    /// [`OutsideSolution`](IntegrationError::OutsideSolution).
    pub fn derivative(&self, t: f64) -> Result<Option<X>, IntegrationError>
    where
        K: KeptMotion<S, X>,
    {
        self.kept.slope(t)
    }

    /// Returns the times of the start, of the ends of steps, and of the events at which a reaction or the end cuts a
    /// step.
    pub fn times<'a>(&'a self) -> impl DoubleEndedIterator<Item = f64> + use<'a, S, X, K>
    where
        K: KeptMotion<S, X>,
        X: 'a,
    {
        self.kept.ends_of_steps()
    }
}

/// The types of what `save(Every(…))`, a list of times or `StepEnds` keep.
#[cfg(feature = "alloc")]
#[diagnostic::on_unimplemented(
    message = "no samples were kept",
    note = "write `.save(Every(0.01))`, `.save(StepEnds)` or a list of times before `.solve(…)`"
)]
pub trait KeptSamples<S, X> {
    /// Returns the samples, in the order of time.
    fn samples(&self) -> &[At<S, X>];
}

#[cfg(feature = "alloc")]
impl<S, X> KeptSamples<S, X> for Vec<At<S, X>> {
    fn samples(&self) -> &[At<S, X>] {
        self
    }
}

impl<S, X, K> Partial<Solution<S, X, K>> {
    /// Returns the solution up to the error.
    #[must_use]
    pub fn solution(&self) -> &Solution<S, X, K> {
        self.value()
    }

    /// Converts the error into the solution up to it.
    #[must_use]
    pub fn into_solution(self) -> Solution<S, X, K> {
        self.into_value()
    }
}

/// The error, and how far the solution goes if there was a step.
impl<S: Scalar, X, K> fmt::Display for Partial<Solution<S, X, K>> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.error().fmt(f)?;
        let solution = self.solution();
        if solution.statistics.attempts() == 0 {
            return Ok(());
        }
        let reached = Readable(solution.last.t.smallest());
        write!(f, " (the solution is known until t = {reached})")
    }
}
