//! Event functions and conditions given by closures.

use super::event_dynamics::SingleNumber;
use super::event_functions::{EventFunctions, detection_by_functions};
use super::memory::Memory;
use super::values::Values;
use super::{Crossing, Detection, Event, LastStep, MetConditions, Occurring, sampling};
use crate::integrate::at::At;
use crate::integrate::dynamics::Dynamics;
use crate::integrate::stepper::Advance;
use crate::scalar::{Lanes, Scalar};

/// The return type of an event function: a number of the scalar of the integration, or an array of them.
///
/// On [lanes](crate::Lanes), whose motions share their steps, it is an `f64` computed from all lanes.
#[diagnostic::on_unimplemented(
    message = "an event function of an integration on `{S}` does not return `{Self}`",
    note = "it returns a number of the scalar of the integration, `x.q[0]` say, or an array of them; on lanes a number `f64` \
            that is made of all lanes"
)]
pub trait EventValues<S: Scalar> {
    /// The numbers whose signs are watched: `f64` or an array of it.
    type Numbers: Values;

    /// Returns the numbers without their derivative parts, in `f64`.
    fn numbers(&self) -> Self::Numbers;

    /// Returns the value at an index in the full precision of the scalar; `None` beyond the last index, and if events
    /// have one time for several motions.
    fn value(&self, index: usize) -> Option<S>;
}

impl<S: SingleNumber> EventValues<S> for S {
    type Numbers = f64;

    fn numbers(&self) -> f64 {
        self.smallest()
    }

    fn value(&self, index: usize) -> Option<S> {
        (index == 0).then_some(*self)
    }
}

impl<S: SingleNumber, const K: usize> EventValues<S> for [S; K] {
    type Numbers = [f64; K];

    fn numbers(&self) -> [f64; K] {
        self.map(Scalar::smallest)
    }

    fn value(&self, index: usize) -> Option<S> {
        self.get(index).copied()
    }
}

impl<const L: usize> EventValues<Lanes<L>> for f64 {
    type Numbers = Self;

    fn numbers(&self) -> Self {
        *self
    }

    fn value(&self, _: usize) -> Option<Lanes<L>> {
        None
    }
}

impl<const L: usize, const K: usize> EventValues<Lanes<L>> for [f64; K] {
    type Numbers = Self;

    fn numbers(&self) -> Self {
        *self
    }

    fn value(&self, _: usize) -> Option<Lanes<L>> {
        None
    }
}

/// The condition that a function of the time and the state crosses zero.
#[derive(Clone, Copy, Debug)]
pub struct FunctionOfState<F> {
    pub(crate) function: F,
    pub(crate) event: Event,
    pub(crate) parts: Option<u32>,
}

impl<F> FunctionOfState<F> {
    /// Creates the event that the function crosses zero in either direction.
    pub(crate) fn new(function: F) -> Self {
        Self {
            function,
            event: Event::new(Crossing::Either),
            parts: None,
        }
    }
}

impl<S, D, F, R> EventFunctions<S, D> for FunctionOfState<F>
where
    S: Scalar,
    D: Dynamics<S> + ?Sized,
    F: FnMut(&At<S, D::State>) -> R,
    R: EventValues<S>,
{
    type Values = R::Numbers;

    fn values(&mut self, _: &D, t: f64, x: &D::State) -> R::Numbers {
        let x = x.clone();
        (self.function)(&At {
            t: S::from_f64(t),
            x,
        })
        .numbers()
    }

    fn function(&mut self, _: &D, t: S, x: &D::State, event: usize) -> Option<S> {
        (self.function)(&At { t, x: x.clone() }).value(event)
    }

    fn event(&self, _: usize) -> Event {
        self.event
    }

    fn parts(&self) -> Option<u32> {
        self.parts
    }

    fn next<T: Advance<S, D>>(
        &mut self,
        memory: &mut Memory<R::Numbers>,
        step: &mut LastStep<'_, S, D, T>,
    ) -> Option<Occurring> {
        sampling::next(self, memory, step)
    }
}

impl<S, D, F, R> Detection<S, D> for FunctionOfState<F>
where
    S: Scalar,
    D: Dynamics<S> + ?Sized,
    F: FnMut(&At<S, D::State>) -> R,
    R: EventValues<S>,
{
    detection_by_functions!(S, D);
}

/// The condition that a predicate of the time and the state holds at the end of a step.
#[derive(Clone, Copy, Debug)]
pub struct PredicateOfState<F>(pub(crate) F);

impl<S, D, F> Detection<S, D> for PredicateOfState<F>
where
    S: Scalar,
    D: Dynamics<S> + ?Sized,
    F: FnMut(&At<S, D::State>) -> bool,
{
    type Memory = ();

    const COUNT: usize = 1;

    fn begin(&mut self, _: &D, _: f64, _: &D::State) {}

    fn holding(&mut self, t: f64, x: &D::State) -> MetConditions {
        let (t, x) = (S::from_f64(t), x.clone());
        MetConditions::of(core::iter::once((self.0)(&At { t, x })))
    }
}
