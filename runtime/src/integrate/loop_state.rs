//! What the loop over steps knows between two of them, and why it is left.

use super::error::IntegrationError;
use super::event::Occurring;
use super::outcome::StopReason;

/// What the loop over steps knows between two of them.
#[derive(Clone, Copy, Debug)]
pub(crate) struct LoopState {
    pub(crate) start: f64,
    pub(crate) end: f64,
    /// The smallest relative pivot that does not end the integration.
    pub(crate) min_pivot: f64,
    /// The number of steps, rejected ones included, at which to stop.
    pub(crate) step_limit: u64,
    /// The time at which the state is updated next, if the motion comes there.
    pub(crate) update: Option<f64>,
    pub(crate) beginning: Beginning,
    /// Whether nothing is left to visit in the last step.
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

/// How a step that the caller has taken ended.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Taken {
    /// At a regular state, as far as the method can tell.
    Regular,
    /// Perhaps at or beyond a singularity.
    Unchecked,
    /// It could not be taken.
    Failed(IntegrationError),
}

/// How a part of an integration begins.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Beginning {
    /// At the initial time.
    Initial,
    /// At a state that a reaction has changed.
    Changed,
    /// Within a step, after a reaction without changes.
    Unchanged,
    /// Behind a step that the caller has taken.
    Stepped(Taken),
}

/// Why a loop over steps ends.
pub(crate) enum Interruption {
    Stop(StopReason),
    /// Events call for a reaction, after which there may be a reason to stop.
    Reaction(Occurring, Option<StopReason>),
    /// The state is to be updated.
    Update,
    /// The caller is to take a step towards this time.
    Step(f64),
}

impl Interruption {
    /// What follows events that call for a reaction.
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
