//! Events: which function, which direction, and what happens there.

use super::Problem;
use super::reaction::{OfDynamics, OfState, Then};
use crate::integrate::at::At;
use crate::integrate::dynamics::Dynamics;
use crate::integrate::error::IntegrationError;
use crate::integrate::event::{
    Crossing, DeclaredEvent, DeclaredEvents, Event, EventDynamics, EventValues, FunctionOfState,
    PredicateOfState, SingleNumber, Watched,
};
use crate::integrate::observer::Flow;
use crate::scalar::Scalar;

/// An event that still needs its action: [`record`](Self::record), [`stop`](Self::stop), [`then`](Self::then) or
/// [`then_with`](Self::then_with). It occurs at zeros of either direction, unless [`rising`](Self::rising) or
/// [`falling`](Self::falling) is said.
#[must_use = "say what happens at the event: `record()`, `stop()` or `then(…)`"]
#[derive(Clone, Copy, Debug)]
pub struct When<P, E> {
    problem: P,
    events: E,
}

/// The events of which the direction is set.
pub trait Directed {
    /// Sets it.
    fn direct(&mut self, change: impl FnMut(Event) -> Event);

    /// Sets the parts of steps.
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

/// One event that the model `M` declares, or several: [`DeclaredEvent`]s.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is not an event that `{M}` declares",
    note = "an event is named by a constant of the model, as `Ball::FLOOR` is of `Ball` with the clause `event(floor = height)`, \
            several by an array of constants; functions of the state are watched for by `when(|x| …)`"
)]
pub trait DeclaredBy<M> {
    /// The events.
    type Events;

    /// Zeros of either direction.
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
    /// An event: where a function of the state crosses zero. It returns a number, or an array of them, each of which is an
    /// event; on [lanes](crate::Lanes), whose motions go on together, `f64`, made of all lanes.
    ///
    /// A closure is sampled in each step ([`When::samples`]), so that two zeros in one of the parts are missed; events that the
    /// model declares ([`on`](Self::on)) are found by their Taylor series under [`Taylor`](crate::Taylor).
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

    /// An event that the model declares by the clause `event`, by its constant: `Ball::FLOOR`; or several.
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

    /// Stops at the first **end of a step** at which the condition holds, or at the start if it holds there: a [`Run`](super::Run) does
    /// not go on while it holds. Steps may be long, and a condition that holds only within one is not seen: the place at which
    /// x > 10 begins to hold is found by an event, `when(|x| x.q[0] - 10.0).rising().stop()`.
    pub fn stop_when<F>(self, condition: F) -> Problem<S, D, K, (C, PredicateOfState<F>), R, O>
    where
        F: FnMut(&At<S, D::State>) -> bool,
    {
        self.with(PredicateOfState(condition), |others, _| others)
    }
}

impl<P, E: Directed> When<P, E> {
    /// Only where it rises through zero.
    pub fn rising(mut self) -> Self {
        self.events
            .direct(|event| event.crossing_by(Crossing::Rising));
        self
    }

    /// Only where it falls through zero.
    pub fn falling(mut self) -> Self {
        self.events
            .direct(|event| event.crossing_by(Crossing::Falling));
        self
    }

    /// Sets the number of equal parts of each step at whose ends the function is evaluated, where it has no series: 8 by
    /// default, and 1 for methods without dense output.
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
    /// The integration stops there.
    pub fn stop(mut self) -> Problem<S, D, K, (C, E), R, O> {
        self.events.direct(Event::terminal);
        self.problem.with(self.events, |others, _| others)
    }

    /// The event is recorded: it is one of [`Solution::events`](crate::Solution::events).
    pub fn record(self) -> Problem<S, D, K, (C, E), R, O> {
        self.problem.with(self.events, |others, _| others)
    }

    /// The event is recorded, and the state changes: a ball bounces, a stage separates. The function changes the state in place
    /// and returns nothing, or `ControlFlow::Break(())` where the integration is to end.
    pub fn then<F, A>(self, reaction: F) -> Problem<S, D, K, (C, E), Then<R, OfState<F>>, O>
    where
        F: FnMut(&mut At<S, D::State>) -> A,
        A: Flow,
    {
        self.reacting(OfState(reaction))
    }

    /// The event is recorded, and the state or the dynamics change: a spring breaks, a load is picked up. The dynamics of an
    /// owned model, `Problem::new(model, start)`, change by [`EquationsOfMotion::change`](crate::EquationsOfMotion::change).
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

/// What an event with an action is: a part of a problem.
#[diagnostic::on_unimplemented(
    message = "it is not said what happens at the event",
    note = "write `.record()`, `.stop()` or `.then(|x| …)` behind it"
)]
pub trait HasAction {}

/// Namesakes of the methods of a problem, by which the compiler says that the event lacks its action. Nothing calls them.
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
