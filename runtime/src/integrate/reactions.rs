//! Reactions to events.

use super::at::At;
use super::dynamics::Dynamics;
use super::event::Reaction;
use super::observer::Flow;
use crate::scalar::Scalar;

/// The reactions to the events of a problem.
pub trait Reactions<S: Scalar, D: Dynamics<S>> {
    /// Whether there are any reactions.
    const REACTS: bool;

    /// Runs the reaction to an event, if there is one.
    fn react(&mut self, event: usize, t: S, x: &mut D::State, dynamics: &mut D) -> Reaction;
}

impl<S: Scalar, D: Dynamics<S>> Reactions<S, D> for () {
    const REACTS: bool = false;

    fn react(&mut self, _: usize, _: S, _: &mut D::State, _: &mut D) -> Reaction {
        Reaction::default()
    }
}

/// Reactions, and one more for `count` events from the index `first` on.
#[derive(Clone, Copy, Debug)]
pub struct Then<R, F> {
    pub(crate) others: R,
    pub(crate) first: usize,
    pub(crate) count: usize,
    pub(crate) reaction: F,
}

impl<S, D, R, F> Reactions<S, D> for Then<R, F>
where
    S: Scalar,
    D: Dynamics<S>,
    R: Reactions<S, D>,
    F: React<S, D>,
{
    const REACTS: bool = true;

    fn react(&mut self, event: usize, t: S, x: &mut D::State, dynamics: &mut D) -> Reaction {
        if !(self.first..self.first + self.count).contains(&event) {
            return self.others.react(event, t, x, dynamics);
        }
        let mut there = At { t, x: x.clone() };
        let reaction = self.reaction.react(&mut there, dynamics);
        *x = there.x;
        reaction
    }
}

/// A reaction to an event.
pub trait React<S: Scalar, D: Dynamics<S>> {
    /// Changes the state, or the dynamics.
    fn react(&mut self, state: &mut At<S, D::State>, dynamics: &mut D) -> Reaction;
}

/// A reaction that is a function of the state.
#[derive(Clone, Copy, Debug)]
pub struct OfState<F>(pub(crate) F);

impl<S, D, F, A> React<S, D> for OfState<F>
where
    S: Scalar,
    D: Dynamics<S>,
    F: FnMut(&mut At<S, D::State>) -> A,
    A: Flow,
{
    fn react(&mut self, state: &mut At<S, D::State>, _: &mut D) -> Reaction {
        Reaction {
            changes: false,
            stops: (self.0)(state).flow().is_break(),
        }
    }
}

/// A reaction that is a function of the state and of the dynamics.
#[derive(Clone, Copy, Debug)]
pub struct OfDynamics<F>(pub(crate) F);

impl<S, D, F, A> React<S, D> for OfDynamics<F>
where
    S: Scalar,
    D: Dynamics<S>,
    F: FnMut(&mut At<S, D::State>, &mut D) -> A,
    A: Flow,
{
    fn react(&mut self, state: &mut At<S, D::State>, dynamics: &mut D) -> Reaction {
        Reaction {
            changes: true,
            stops: (self.0)(state, dynamics).flow().is_break(),
        }
    }
}
