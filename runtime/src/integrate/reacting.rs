//! Dynamics that reactions to events may change, and those that stay as they are.

use super::event::{Occurring, Reaction};

/// The dynamics of an integration, and the reaction to events.
pub(crate) trait React<D: ?Sized, X> {
    /// Whether there is a reaction.
    const REACTS: bool;

    fn dynamics(&self) -> &D;

    /// Reacts to events, in the order of their indices.
    fn react(&mut self, occurring: Occurring, x: &mut X) -> Reaction;
}

/// Dynamics that stay as they are.
pub(crate) struct Unreacting<'a, D: ?Sized>(pub(crate) &'a D);

impl<D: ?Sized, X> React<D, X> for Unreacting<'_, D> {
    const REACTS: bool = false;

    fn dynamics(&self) -> &D {
        self.0
    }

    fn react(&mut self, _: Occurring, _: &mut X) -> Reaction {
        Reaction::Unchanged
    }
}

/// Dynamics with a reaction that may change them.
pub(crate) struct Reacting<'a, D: ?Sized, F> {
    pub(crate) dynamics: &'a mut D,
    pub(crate) reaction: F,
}

impl<D: ?Sized, X: Clone, F> React<D, X> for Reacting<'_, D, F>
where
    F: FnMut(usize, f64, &mut X, &mut D) -> Reaction,
{
    const REACTS: bool = true;

    fn dynamics(&self) -> &D {
        self.dynamics
    }

    fn react(&mut self, occurring: Occurring, x: &mut X) -> Reaction {
        let mut all = Reaction::Unchanged;
        for event in occurring.events.indices() {
            let before = x.clone();
            match (self.reaction)(event, occurring.t, x, self.dynamics) {
                Reaction::Unchanged => *x = before,
                Reaction::Changed => all = Reaction::Changed,
                Reaction::Stop => return Reaction::Stop,
            }
        }
        all
    }
}
