//! The state of the loop over steps between two of them, and the reasons to leave it.

use super::error::IntegrationError;
use super::event::Occurring;
use super::outcome::StopReason;

/// The state of the loop over steps between two of them.
#[derive(Clone, Copy, Debug)]
pub(crate) struct LoopState {
    pub(crate) start: f64,
    pub(crate) end: f64,
    /// The smallest relative pivot that does not end the integration.
    pub(crate) min_pivot: f64,
    /// The number of steps, rejected ones included, at which to stop.
    pub(crate) step_limit: u64,
    /// The time of the next update of the state, if the motion reaches it.
    pub(crate) update: Option<f64>,
    pub(crate) beginning: Beginning,
    /// Whether everything in the last step has been visited.
    pub(crate) is_visited: bool,
}

/// Who takes the steps.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Steps {
    /// The loop.
    Own,
    /// The caller, for several motions at once.
    Shared,
}

/// The result of a step that the caller has taken.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Taken {
    /// It ended at a regular state, as far as the method can tell.
    Regular,
    /// It may have ended at or beyond a singularity.
    Unchecked,
    /// It could not be taken.
    Failed(IntegrationError),
}

/// The beginning of a part of an integration.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Beginning {
    /// At the initial time.
    Initial,
    /// At a state that a reaction has changed.
    Changed,
    /// Within a step, after a reaction without changes.
    Unchanged,
    /// After a step that the caller has taken.
    Stepped(Taken),
}

/// The reason for which a loop over steps ends.
pub(crate) enum Interruption {
    Stop(StopReason),
    /// Events require a reaction, after which there may be a reason to stop.
    Reaction(Occurring, Option<StopReason>),
    /// The state is to be updated.
    Update,
    /// The caller is to take a step towards this time.
    Step(f64),
}

impl Interruption {
    /// Returns this interruption, preceded by events that require a reaction.
    pub(crate) fn after(self, occurring: Occurring) -> Self {
        match self {
            Self::Stop(reason) => Self::Reaction(occurring, Some(reason)),
            Self::Reaction(more, reason) => {
                let events = occurring.events.or(more.events);
                Self::Reaction(
                    Occurring {
                        events,
                        ..occurring
                    },
                    reason,
                )
            }
            Self::Update | Self::Step(_) => self,
        }
    }
}

impl From<StopReason> for Interruption {
    fn from(reason: StopReason) -> Self {
        Self::Stop(reason)
    }
}
