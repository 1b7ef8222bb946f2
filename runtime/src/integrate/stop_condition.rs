//! Stop conditions: predicates, and events.

use super::dynamics::Dynamics;
use super::event::{
    Both, DeclaredEvents, Detection, FunctionOfState, MetConditions, PredicateOfState, ZeroCrossing,
};
use crate::scalar::Scalar;

/// A condition on which a [`Driver`](crate::Driver) stops, or events that it watches for; made by
/// [`Driver::stop_when`](crate::Driver::stop_when), [`Driver::stop_at_zero`](crate::Driver::stop_at_zero),
/// [`Driver::stop_at_crossing`](crate::Driver::stop_at_crossing), [`Driver::events`](crate::Driver::events) and
/// [`Driver::declared_events`](crate::Driver::declared_events), and by nothing else: the trait is sealed. All that are made
/// count.
pub trait StopCondition<S: Scalar, D: Dynamics<S> + ?Sized>: Detection<S, D> {}

impl<S: Scalar, D: Dynamics<S> + ?Sized, C: Detection<S, D>> StopCondition<S, D> for C {}

/// No stop condition.
#[derive(Clone, Copy, Debug, Default)]
pub struct Unconditional;

/// The condition that a function of time and state is true at the end of a step.
#[derive(Clone, Copy, Debug)]
pub struct Predicate<F>(pub(crate) F);

impl<S: Scalar, D: Dynamics<S> + ?Sized> Detection<S, D> for Unconditional {
    type Memory = ();

    const COUNT: usize = 0;

    fn begin(&mut self, _: &D, _: f64, _: &D::State) {}
}

impl<S: Scalar, D: Dynamics<S> + ?Sized, F: FnMut(f64, &D::State) -> bool> Detection<S, D>
    for Predicate<F>
{
    type Memory = ();

    const COUNT: usize = 1;

    fn begin(&mut self, _: &D, _: f64, _: &D::State) {}

    fn holding(&mut self, t: f64, x: &D::State) -> MetConditions {
        MetConditions::of(core::iter::once((self.0)(t, x)))
    }
}

/// A list of conditions and events to which others are added.
pub trait Extensible: Sized {
    /// The list with another one behind it.
    type With<E>;

    /// Adds conditions and events behind those that there are.
    fn with<E>(self, others: E) -> Self::With<E>;
}

impl Extensible for Unconditional {
    type With<E> = E;

    fn with<E>(self, others: E) -> E {
        others
    }
}

/// Lists that are there stay.
macro_rules! extended_by_both {
    ($($list:ident<$($parameter:ident),*>)*) => {$(
        impl<$($parameter),*> Extensible for $list<$($parameter),*> {
            type With<E> = Both<Self, E>;

            fn with<E>(self, others: E) -> Both<Self, E> {
                Both(self, others)
            }
        }
    )*};
}

extended_by_both!(Predicate<F> ZeroCrossing<F, W> PredicateOfState<F> FunctionOfState<F> Both<A, B>);

impl<const K: usize> Extensible for DeclaredEvents<K> {
    type With<E> = Both<Self, E>;

    fn with<E>(self, others: E) -> Both<Self, E> {
        Both(self, others)
    }
}
