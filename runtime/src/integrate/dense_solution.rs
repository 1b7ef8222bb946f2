//! A motion that can be evaluated at any time. Needs the feature `alloc`.

use alloc::vec::Vec;
use core::{fmt, marker::PhantomData};

use super::at::At;
use super::collector::Collector;
use super::dense_output::{DenseOutput, Interpolant};
use super::dynamics::Dynamics;
use super::error::IntegrationError;
use crate::linalg::VectorSpace;
use crate::scalar::Scalar;

/// A motion with the dense output of each of its steps, kept by [`Dense`](crate::problem::Dense).
///
/// Between the ends of steps it is as accurate as the dense output of the method: for [`Dop853`](crate::Dop853) this is
/// of order 7; for [`Taylor`](crate::Taylor) it is the polynomial of the step itself.
#[derive(Clone, PartialEq)]
pub struct DenseSolution<X, P, S = f64> {
    initial: At<f64, X>,
    segments: Vec<Segment<P>>,
    last: At<f64, X>,
    scalar: PhantomData<S>,
}

/// A step, or its part up to an event.
#[derive(Clone, Debug, PartialEq)]
struct Segment<P> {
    end: f64,
    interpolant: P,
}

/// The type of what `save(Dense)` keeps.
#[diagnostic::on_unimplemented(
    message = "the motion was not kept",
    note = "write `.save(Dense)` before `.solve(…)`"
)]
pub trait KeptMotion<S, X> {
    /// Returns the state at a time; at a jump, the state after the jump.
    fn state(&self, t: f64) -> Result<X, IntegrationError>;

    /// Returns the state at a time; at a jump, the state before the jump.
    fn state_before(&self, t: f64) -> Result<X, IntegrationError>;

    /// Returns the derivative of the interpolating polynomial at a time, or `None` if there is no step. For a
    /// mechanical system it holds velocities and accelerations.
    fn slope(&self, t: f64) -> Result<Option<X>, IntegrationError>;

    /// Returns the times of the ends of steps and of events, the initial time first.
    fn ends_of_steps(&self) -> impl DoubleEndedIterator<Item = f64>;
}

impl<S, X, P> KeptMotion<S, X> for DenseSolution<X, P, S>
where
    S: Scalar,
    X: VectorSpace<S>,
    P: Interpolant<S, X>,
{
    fn state(&self, t: f64) -> Result<X, IntegrationError> {
        if t - self.last.t == 0.0 {
            return Ok(self.last.x.clone());
        }
        self.interpolated(t, |end, t| end <= t)
    }

    fn state_before(&self, t: f64) -> Result<X, IntegrationError> {
        if t - self.initial.t == 0.0 {
            return Ok(self.initial.x.clone());
        }
        self.interpolated(t, |end, t| end < t)
    }

    fn slope(&self, t: f64) -> Result<Option<X>, IntegrationError> {
        let found = self.segment(t, |end, t| end <= t)?;
        Ok(found.map(|segment| segment.interpolant.derivative(t)))
    }

    fn ends_of_steps(&self) -> impl DoubleEndedIterator<Item = f64> {
        let ends = self.segments.iter().map(|segment| segment.end);
        core::iter::once(self.initial.t).chain(ends)
    }
}

impl<X, P, S> DenseSolution<X, P, S> {
    /// Returns the end of the last segment, or the initial time if there is none.
    fn end(&self) -> f64 {
        self.segments.last().map_or(self.initial.t, |last| last.end)
    }
}

impl<X, P, S> DenseSolution<X, P, S>
where
    S: Scalar,
    X: VectorSpace<S>,
    P: Interpolant<S, X>,
{
    /// Returns the state at a time from the first segment that is not `over` there.
    fn interpolated(&self, t: f64, over: impl Fn(f64, f64) -> bool) -> Result<X, IntegrationError> {
        let state = |segment: &Segment<P>| segment.interpolant.at(t);
        let found = self.segment(t, over)?;
        Ok(found.map_or_else(|| self.initial.x.clone(), state))
    }

    /// Returns the first segment that is not `over` at a time; at the end, the last segment.
    fn segment(
        &self,
        t: f64,
        over: impl Fn(f64, f64) -> bool,
    ) -> Result<Option<&Segment<P>>, IntegrationError> {
        let (start, end) = (self.initial.t, self.end());
        let sign = if end < start { -1.0 } else { 1.0 };
        if !(sign * start <= sign * t && sign * t <= sign * end) {
            return Err(IntegrationError::OutsideSolution {
                time: t,
                start,
                end,
            });
        }
        let is_over = |segment: &Segment<P>| over(sign * segment.end, sign * t);
        let index = self.segments.partition_point(is_over);
        Ok(self.segments.get(index).or(self.segments.last()))
    }
}

impl<X, P, S> fmt::Debug for DenseSolution<X, P, S> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("DenseSolution")
            .field("start", &self.initial.t)
            .field("end", &self.end())
            .field("segments", &self.segments.len())
            .finish_non_exhaustive()
    }
}

/// The steps collected so far, and the initial state.
pub struct Whole<X, P> {
    initial: At<f64, X>,
    segments: Vec<Segment<P>>,
}

impl<X, P> From<At<f64, X>> for Whole<X, P> {
    fn from(initial: At<f64, X>) -> Self {
        Self {
            initial,
            segments: Vec::new(),
        }
    }
}

impl<X, P> Whole<X, P> {
    /// Returns the motion until the last state.
    pub(super) fn until<S>(self, last: At<f64, X>) -> DenseSolution<X, P, S> {
        DenseSolution {
            initial: self.initial,
            segments: self.segments,
            last,
            scalar: PhantomData,
        }
    }
}

impl<S, D, T> Collector<S, D, T> for Whole<D::State, T::Interpolant>
where
    S: Scalar,
    D: Dynamics<S>,
    T: DenseOutput<S, D>,
{
    fn step(&mut self, dynamics: &D, stepper: &mut T, end: f64) {
        if let Some(interpolant) = stepper.interpolant(dynamics) {
            self.segments.push(Segment { end, interpolant });
        }
    }
}
