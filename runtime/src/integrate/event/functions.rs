//! Event functions that are closures.

use super::values::Values;
use super::{Crossing, Detection, Event};
use crate::integrate::dynamics::Dynamics;
use crate::scalar::Scalar;

/// What is watched for: a direction or an [`Event`], or an array of them for an array of values.
pub trait Watched {
    /// The values of the event functions.
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
        Event::new(*self).terminal()
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
    /// The parts of a step at whose ends the function is evaluated, if it is set.
    pub(crate) parts: Option<u32>,
}

impl<S, D, F, W> Detection<S, D> for ZeroCrossing<F, W>
where
    S: Scalar,
    D: Dynamics<S> + ?Sized,
    W: Watched,
    F: FnMut(f64, &D::State) -> W::Values,
{
    type Values = W::Values;

    fn values(&mut self, _: &D, t: f64, x: &D::State) -> W::Values {
        (self.function)(t, x)
    }

    fn event(&self, index: usize) -> Event {
        self.events.event(index)
    }

    fn parts(&self) -> Option<u32> {
        self.parts
    }
}
