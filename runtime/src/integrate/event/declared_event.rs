//! Declared events, by name and by index.

use core::fmt;
use core::marker::PhantomData;

use super::Event;

/// An event declared in the clause `event` of `M`: the constants of the model have this type, and
/// [`Problem::on`](crate::Problem::on) takes them.
///
/// ```
/// use lagrangian::prelude::*;
///
/// #[derive(Lagrangian)]
/// #[lagrangian(
///     coordinates(height),
///     kinetic = 0.5 * m * dot(height).powi(2),
///     event(floor = height, apex = dot(height)),
/// )]
/// struct Ball { m: f64 }
///
/// let ball = Ball { m: 0.1 };
/// let values = ball.event_functions(&State::new(0.0, [2.0], [-3.0]));
/// assert_eq!(values[Ball::APEX.index()], -3.0);
/// assert_eq!(Ball::EVENTS[Ball::APEX.index()], "apex");
/// ```
pub struct DeclaredEvent<M> {
    index: usize,
    model: PhantomData<fn() -> M>,
}

impl<M> DeclaredEvent<M> {
    /// Creates the event with an index, as the constants of the derive macro do; for dynamics that are written by hand.
    #[must_use]
    pub const fn new(index: usize) -> Self {
        Self {
            index,
            model: PhantomData,
        }
    }

    /// Returns its index among the events of the declaration.
    #[must_use]
    pub const fn index(self) -> usize {
        self.index
    }
}

impl<M> Clone for DeclaredEvent<M> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<M> Copy for DeclaredEvent<M> {}

impl<M> PartialEq for DeclaredEvent<M> {
    fn eq(&self, other: &Self) -> bool {
        self.index == other.index
    }
}

impl<M> Eq for DeclaredEvent<M> {}

impl<M> fmt::Debug for DeclaredEvent<M> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_tuple("DeclaredEvent").field(&self.index).finish()
    }
}

/// Some of the events that the dynamics declare, by their indices, and the crossings that are watched.
#[derive(Clone, Copy, Debug)]
pub struct DeclaredEvents<const K: usize> {
    pub(crate) events: [(usize, Event); K],
    /// The number of parts of a step at whose ends the functions are evaluated, if it is set.
    pub(crate) parts: Option<u32>,
}

impl<const K: usize> DeclaredEvents<K> {
    pub(super) fn event(&self, index: usize) -> Event {
        let event = self.events.get(index);
        event.map_or(Event::either(), |(_, event)| *event)
    }
}
