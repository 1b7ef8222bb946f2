//! Events: zeros of functions of time and state within the steps of an integration.
//!
//! The input is the last step of any method; the output is the events that occur in it, in the order of time. Their
//! consequences are decided elsewhere. Nothing here allocates.
//!
//! L. F. Shampine & S. Thompson, *Event Location for Ordinary Differential Equations*, Comput. Math. Appl. **39**
//! (2000) 43–54, show that the error of an integration that restarts at events is of the order of the method.

mod detection;
mod event_functions;
mod both;
mod junction;
mod closing;
mod last_step;
mod location;
mod memory;
mod sampling;
mod sides;
mod values;
mod functions;
mod event_dynamics;
mod polynomial;
mod window;
mod exclusion;
mod functions_in_step;
mod terms;
mod one_signed;
mod isolation;
mod simple_zero;
mod declared;
mod declared_event;
mod event_time;
mod met_conditions;

pub use declared_event::DeclaredEvent;
pub(crate) use declared_event::DeclaredEvents;
pub use detection::Watched;
pub(crate) use detection::{Detection, Occurring};
pub use event_dynamics::{EventDynamics, SingleNumber};
pub(crate) use event_functions::EventFunctions;
pub(crate) use event_time::{Located, differs, moved};
pub use functions::EventValues;
pub(crate) use functions::{FunctionOfState, PredicateOfState};
pub(crate) use last_step::LastStep;
pub(crate) use location::Bracket;
pub(crate) use memory::{Memory, Remembers};
pub use met_conditions::MetConditions;
pub(crate) use one_signed::{OneSigned, OneSignedInLanes};
pub(crate) use terms::Terms;

use core::ops::Deref;

use super::at::At;

/// The direction in which an event function crosses zero in the course of an integration, even of a backward one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Crossing {
    /// From negative to positive.
    Rising,
    /// From positive to negative.
    Falling,
    /// In either direction.
    Either,
}

impl Crossing {
    /// Whether zero is crossed or reached between two values. There is no crossing from zero, and NaN has no sign.
    pub(crate) fn between(self, before: f64, after: f64) -> bool {
        let rises = before < 0.0 && after >= 0.0;
        let falls = before > 0.0 && after <= 0.0;
        match self {
            Self::Rising => rises,
            Self::Falling => falls,
            Self::Either => rises || falls,
        }
    }
}

/// A zero crossing that is watched for: its direction, and whether the integration stops there.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Event {
    crossing: Crossing,
    is_terminal: bool,
}

impl Event {
    /// Returns the event that the function crosses zero in the given direction, or reaches it in that direction.
    #[must_use]
    pub const fn new(crossing: Crossing) -> Self {
        Self {
            crossing,
            is_terminal: false,
        }
    }

    /// Returns the event that the function crosses zero in either direction.
    #[must_use]
    pub const fn either() -> Self {
        Self::new(Crossing::Either)
    }

    /// Makes the integration stop at the event.
    #[must_use]
    pub const fn terminal(mut self) -> Self {
        self.is_terminal = true;
        self
    }

    /// Returns this event with another direction.
    pub(crate) const fn crossing_by(mut self, crossing: Crossing) -> Self {
        self.crossing = crossing;
        self
    }

    /// Returns the direction.
    #[must_use]
    pub const fn crossing(self) -> Crossing {
        self.crossing
    }

    /// Whether the integration stops there.
    #[must_use]
    pub const fn is_terminal(self) -> bool {
        self.is_terminal
    }
}

/// The request of a reaction to an event. A change of the state itself is detected by comparison.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Reaction {
    /// The dynamics may have changed: the method restarts.
    pub(crate) changes: bool,
    /// The integration ends at the event.
    pub(crate) stops: bool,
}

/// An event that occurred, with its time and the state there before any reaction. It dereferences to the state:
/// `occurrence.t`, `occurrence.q[0]`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Occurrence<X, S = f64> {
    /// The number of the event. Events and conditions are counted from 0 in the order of the settings; each event of an
    /// array counts. Use [`is`](Self::is) to compare with an event of the declaration.
    pub event: usize,
    /// The state at the event. Its time has derivative parts and the digits of a double-double. The derivative parts of
    /// the state include the change of the event's time.
    pub state: At<S, X>,
    /// The index of the event in the declaration, if it was declared.
    pub(crate) declared: Option<usize>,
}

impl<X, S> Occurrence<X, S> {
    /// Whether it is this event of the declaration.
    ///
    /// ```
    /// use lagrangian::prelude::*;
    ///
    /// #[derive(Lagrangian)]
    /// #[lagrangian(
    ///     coordinates(height),
    ///     kinetic = 0.5 * dot(height).powi(2),
    ///     potential = 10.0 * height,
    ///     event(floor = height, apex = dot(height)),
    /// )]
    /// struct Ball;
    ///
    /// let motion = Problem::new(&Ball, State::new(0.0, [0.0], [20.0]))
    ///     .when(|ball| ball.q[0] - 15.0).record()
    ///     .on([Ball::APEX, Ball::FLOOR]).record()
    ///     .solve(5.0, Dop853::new())?;
    /// let apex = motion.events().iter().find(|event| event.is(Ball::APEX));
    /// assert!((apex.map_or(0.0, |apex| apex.t) - 2.0).abs() < 1e-9);
    /// # Ok::<(), IntegrationError>(())
    /// ```
    #[must_use]
    pub fn is<M>(&self, event: DeclaredEvent<M>) -> bool {
        self.declared == Some(event.index())
    }
}

impl<X, S> Deref for Occurrence<X, S> {
    type Target = At<S, X>;

    fn deref(&self) -> &At<S, X> {
        &self.state
    }
}
