//! Dynamics that reactions to events may change, and those that stay as they are.

use super::dynamics::Dynamics;
use super::event::Reaction;
use crate::scalar::Scalar;

/// The dynamics of an integration, and the reaction to events.
pub(crate) trait React<S: Scalar, D: Dynamics<S> + ?Sized> {
    /// Whether there is a reaction.
    const REACTS: bool;

    fn dynamics(&self) -> &D;

    /// Reacts to an event at a time.
    fn react(&mut self, event: usize, t: S, x: &mut D::State) -> Reaction;
}

/// Dynamics that stay as they are.
pub(crate) struct Unreacting<'a, D: ?Sized>(pub(crate) &'a D);

impl<S: Scalar, D: Dynamics<S> + ?Sized> React<S, D> for Unreacting<'_, D> {
    const REACTS: bool = false;

    fn dynamics(&self) -> &D {
        self.0
    }

    fn react(&mut self, _: usize, _: S, _: &mut D::State) -> Reaction {
        Reaction::Unchanged
    }
}

/// Dynamics with a reaction that may change them.
pub(crate) struct Reacting<'a, D: ?Sized, F> {
    pub(crate) dynamics: &'a mut D,
    pub(crate) reaction: F,
}

impl<S: Scalar, D: Dynamics<S> + ?Sized, F> React<S, D> for Reacting<'_, D, F>
where
    F: FnMut(usize, S, &mut D::State, &mut D) -> Reaction,
{
    const REACTS: bool = true;

    fn dynamics(&self) -> &D {
        self.dynamics
    }

    fn react(&mut self, event: usize, t: S, x: &mut D::State) -> Reaction {
        (self.reaction)(event, t, x, self.dynamics)
    }
}
