//! Event functions that are closures.

use super::detection::detection_by_functions;
use super::event_dynamics::SingleNumber;
use super::values::Values;
use super::{Crossing, Detection, Event, EventFunctions};
use crate::integrate::dynamics::Dynamics;
use crate::scalar::{Lanes, Scalar};

/// What an event function returns: a number of the scalar of the integration, or an array of them. On
/// [lanes](crate::Lanes), whose motions go on together, it is a plain number, made of all lanes.
#[diagnostic::on_unimplemented(
    message = "an event function of an integration on `{S}` does not return `{Self}`",
    note = "it returns a number of the scalar of the integration, `x.q[0]` say, or an array of them; on lanes a number `f64` \
            that is made of all lanes"
)]
pub trait EventValues<S: Scalar> {
    /// The numbers of which the signs are watched: `f64` or an array of it.
    type Numbers: Values;

    /// The numbers without their derivative parts, in `f64`.
    fn numbers(&self) -> Self::Numbers;

    /// The value of an index with all that the scalar has of it; none beyond the last, and where events have one time for
    /// several motions.
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

/// What is watched for: a direction or an [`Event`], or an array of them for an array of values.
pub trait Watched {
    /// The numbers of which the signs are watched.
    type Values: Values;

    /// The event of an index; the last one beyond it.
    fn event(&self, index: usize) -> Event;
}

impl Watched for Event {
    type Values = f64;

    fn event(&self, _: usize) -> Event {
        *self
    }
}

impl Watched for Crossing {
    type Values = f64;

    fn event(&self, _: usize) -> Event {
        Event::new(*self)
    }
}

impl<W: Watched<Values = f64>, const K: usize> Watched for [W; K] {
    type Values = [f64; K];

    fn event(&self, index: usize) -> Event {
        let watched = self.get(index).or(self.last());
        watched.map_or(Event::either(), |watched| watched.event(0))
    }
}

/// The condition that an event function of time and state crosses zero, or one of several: `events` is a
/// [`Crossing`] or an [`Event`] for one value, or an array of them for an array of values.
#[derive(Clone, Copy, Debug)]
pub struct ZeroCrossing<F, W = Crossing> {
    /// The event function.
    pub(crate) function: F,
    /// What is watched for.
    pub(crate) events: W,
    /// Whether the integration stops at each of them, whatever it says itself.
    pub(crate) stops: bool,
    /// The parts of a step at whose ends the function is evaluated, if it is set.
    pub(crate) parts: Option<u32>,
}

impl<S, D, F, W, R> EventFunctions<S, D> for ZeroCrossing<F, W>
where
    S: Scalar,
    D: Dynamics<S> + ?Sized,
    W: Watched,
    F: FnMut(S, &D::State) -> R,
    R: EventValues<S, Numbers = W::Values>,
{
    type Values = W::Values;

    fn values(&mut self, _: &D, t: f64, x: &D::State) -> W::Values {
        (self.function)(S::from_f64(t), x).numbers()
    }

    fn function(&mut self, _: &D, t: S, x: &D::State, event: usize) -> Option<S> {
        (self.function)(t, x).value(event)
    }

    fn event(&self, index: usize) -> Event {
        let event = self.events.event(index);
        if self.stops { event.terminal() } else { event }
    }

    fn parts(&self) -> Option<u32> {
        self.parts
    }
}

impl<S, D, F, W, R> Detection<S, D> for ZeroCrossing<F, W>
where
    S: Scalar,
    D: Dynamics<S> + ?Sized,
    W: Watched,
    F: FnMut(S, &D::State) -> R,
    R: EventValues<S, Numbers = W::Values>,
{
    detection_by_functions!(S, D);
}
