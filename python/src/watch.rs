//! What is done at events.

/// Which events are recorded, and which stop the motion: for each event where it rises, then for each where it falls.
#[derive(Clone, Debug, Default)]
pub struct Watch {
    /// Whether the event is kept.
    pub recorded: Vec<bool>,
    /// Whether the motion ends there.
    pub stops: Vec<bool>,
}

impl Watch {
    /// Whether an event is kept.
    #[must_use]
    pub fn records(&self, event: usize) -> bool {
        self.recorded.get(event).copied().unwrap_or(false)
    }

    /// Whether the motion ends at an event.
    #[must_use]
    pub fn stops_at(&self, event: usize) -> bool {
        self.stops.get(event).copied().unwrap_or(false)
    }
}
