//! The settings of events: their functions, directions and actions.

use super::Problem;
use crate::integrate::at::At;
use crate::integrate::dynamics::Dynamics;
use crate::integrate::error::IntegrationError;
use crate::integrate::event::{
    Crossing, DeclaredEvent, DeclaredEvents, Event, EventDynamics, EventValues, FunctionOfState,
    PredicateOfState, SingleNumber, Watched,
};
use crate::integrate::observer::Flow;
use crate::integrate::reactions::{OfDynamics, OfState, Then};
use crate::scalar::Scalar;

/// An event that still needs an action: [`record`](Self::record), [`stop`](Self::stop), [`then`](Self::then) or
/// [`then_with`](Self::then_with).
///
/// It occurs at zeros in either direction, unless it is restricted by [`rising`](Self::rising) or
/// [`falling`](Self::falling).
#[must_use = "say what happens at the event: `record()`, `stop()` or `then(…)`"]
#[derive(Clone, Copy, Debug)]
pub struct When<P, E> {
    problem: P,
    events: E,
}

/// Events whose direction can be set.
pub trait Directed {
    /// Changes the direction of each event.
    fn direct(&mut self, change: impl FnMut(Event) -> Event);

    /// Sets the number of parts of a step.
    fn sample(&mut self, parts: u32);
}

impl<F> Directed for FunctionOfState<F> {
    fn direct(&mut self, mut change: impl FnMut(Event) -> Event) {
        self.event = change(self.event);
    }

    fn sample(&mut self, parts: u32) {
        self.parts = Some(parts);
    }
}

impl<const K: usize> Directed for DeclaredEvents<K> {
    fn direct(&mut self, mut change: impl FnMut(Event) -> Event) {
        for (_, event) in &mut self.events {
            *event = change(*event);
        }
    }

    fn sample(&mut self, parts: u32) {
        self.parts = Some(parts);
    }
}

/// One or several events that the model `M` declares: [`DeclaredEvent`]s.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is not an event that `{M}` declares",
    note = "an event is named by a constant of the model, as `Ball::FLOOR` is of `Ball` with the clause `event(floor = height)`, \
            several by an array of constants; functions of the state are watched for by `when(|x| …)`"
)]
pub trait DeclaredBy<M> {
    /// The type of the events.
    type Events;

    /// Returns the events, at zeros in either direction.
    fn events(self) -> Self::Events;
}

impl<M> DeclaredBy<M> for DeclaredEvent<M> {
    type Events = DeclaredEvents<1>;

    fn events(self) -> DeclaredEvents<1> {
        [self].events()
    }
}

impl<M, const N: usize> DeclaredBy<M> for [DeclaredEvent<M>; N] {
    type Events = DeclaredEvents<N>;

    fn events(self) -> DeclaredEvents<N> {
        DeclaredEvents {
            events: self.map(|event| (event.index(), Event::either())),
            parts: None,
        }
    }
}

impl<S: Scalar, D: Dynamics<S>, K, C, R, O> Problem<S, D, K, C, R, O> {
    /// Adds an event at the zeros of a function of the state. The function returns a number, or an array of numbers,
    /// each of which is an event; on [lanes](crate::Lanes), whose motions share their steps, it returns an `f64`
    /// computed from all lanes.
    ///
    /// A closure is sampled in each step ([`When::samples`]), so that a pair of zeros in one part of a step is missed.
    /// Events that the model declares ([`on`](Self::on)) are found from their Taylor series with
    /// [`Taylor`](crate::Taylor).
    pub fn when<F, V>(self, function: F) -> When<Self, FunctionOfState<F>>
    where
        F: FnMut(&At<S, D::State>) -> V,
        V: EventValues<S>,
    {
        When {
            problem: self,
            events: FunctionOfState::new(function),
        }
    }

    /// Adds one or several events that the model declares in the clause `event`, by their constants, such as
    /// `Ball::FLOOR`.
    pub fn on<E, M>(self, events: E) -> When<Self, E::Events>
    where
        S: SingleNumber,
        D: EventDynamics<S, Model = M>,
        E: DeclaredBy<M>,
    {
        When {
            problem: self,
            events: events.events(),
        }
    }

    /// Stops at the first **end of a step** at which the condition holds, or at the start if it holds there; a
    /// [`Run`](super::Run) does not continue while it holds. Steps may be long, and a condition that holds only within
    /// a step is not noticed. To find the place at which x > 10 begins to hold, use an event:
    /// `when(|x| x.q[0] - 10.0).rising().stop()`.
    pub fn stop_when<F>(self, condition: F) -> Problem<S, D, K, (C, PredicateOfState<F>), R, O>
    where
        F: FnMut(&At<S, D::State>) -> bool,
    {
        self.with(PredicateOfState(condition), |others, _| others)
    }
}

impl<P, E: Directed> When<P, E> {
    /// Restricts the event to zeros at which the function rises.
    pub fn rising(mut self) -> Self {
        self.events
            .direct(|event| event.crossing_by(Crossing::Rising));
        self
    }

    /// Restricts the event to zeros at which the function falls.
    pub fn falling(mut self) -> Self {
        self.events
            .direct(|event| event.crossing_by(Crossing::Falling));
        self
    }

    /// Sets the number of equal parts of each step at whose ends the function is evaluated if it has no series. The
    /// default is 8, or 1 for methods without dense output.
    pub fn samples(mut self, parts: u32) -> Self {
        self.events.sample(parts);
        self
    }
}

impl<S, D, K, C, R, O, E> When<Problem<S, D, K, C, R, O>, E>
where
    S: Scalar,
    D: Dynamics<S>,
    E: Directed + Watched<S, D>,
{
    /// Stops the integration at the event.
    pub fn stop(mut self) -> Problem<S, D, K, (C, E), R, O> {
        self.events.direct(Event::terminal);
        self.problem.with(self.events, |others, _| others)
    }

    /// Records the event in [`Solution::events`](crate::Solution::events).
    pub fn record(self) -> Problem<S, D, K, (C, E), R, O> {
        self.problem.with(self.events, |others, _| others)
    }

    /// Records the event and changes the state: a ball bounces, a stage separates. The function changes the state in
    /// place and returns nothing, or `ControlFlow::Break(())` to end the integration.
    pub fn then<F, A>(self, reaction: F) -> Problem<S, D, K, (C, E), Then<R, OfState<F>>, O>
    where
        F: FnMut(&mut At<S, D::State>) -> A,
        A: Flow,
    {
        self.reacting(OfState(reaction))
    }

    /// Records the event and changes the state or the dynamics: a spring breaks, a load is picked up. The dynamics of
    /// an owned model, `Problem::new(model, start)`, are changed by
    /// [`EquationsOfMotion::change`](crate::EquationsOfMotion::change).
    pub fn then_with<F, A>(self, reaction: F) -> Problem<S, D, K, (C, E), Then<R, OfDynamics<F>>, O>
    where
        F: FnMut(&mut At<S, D::State>, &mut D) -> A,
        A: Flow,
    {
        self.reacting(OfDynamics(reaction))
    }

    fn reacting<F>(self, reaction: F) -> Problem<S, D, K, (C, E), Then<R, F>, O> {
        self.problem.with(self.events, |others, first| Then {
            others,
            first,
            count: E::COUNT,
            reaction,
        })
    }
}

/// Implemented by no type; the methods below require it, so that an event without an action is an error with an
/// explanation.
#[diagnostic::on_unimplemented(
    message = "it is not said what happens at the event",
    note = "write `.record()`, `.stop()` or `.then(|x| …)` behind it"
)]
pub trait HasAction {}

/// Methods with the names of methods of a problem, by which the compiler reports that the event lacks its action.
/// Nothing calls them.
#[doc(hidden)]
impl<P, E> When<P, E> {
    pub fn solve<T, I>(self, _: T, _: I) -> Result<(), IntegrationError>
    where
        Self: HasAction,
    {
        Ok(())
    }

    pub fn start<I>(self, _: I) -> Result<(), IntegrationError>
    where
        Self: HasAction,
    {
        Ok(())
    }

    pub fn save<K>(self, _: K) -> P
    where
        Self: HasAction,
    {
        self.problem
    }

    pub fn on<V>(self, _: V) -> P
    where
        Self: HasAction,
    {
        self.problem
    }

    pub fn max_steps(self, _: u64) -> P
    where
        Self: HasAction,
    {
        self.problem
    }
}
