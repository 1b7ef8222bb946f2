//! What an integration found, as numbers.

use lagrangian::{At, IntegrationError, Occurrence, Phase, Solution, StopReason};

use crate::instant::Instant;
use crate::watch::Watch;

/// A time, coordinates and velocities.
#[derive(Clone, Debug, PartialEq)]
pub struct Reached {
    /// The time.
    pub t: f64,
    /// The coordinates.
    pub q: Vec<f64>,
    /// The velocities.
    pub v: Vec<f64>,
}

impl Reached {
    pub(crate) fn instant(&self) -> Instant<'_> {
        Instant {
            t: self.t,
            q: &self.q,
            v: &self.v,
        }
    }

    pub(crate) fn of<Z, const N: usize>(state: &At<f64, Phase<f64, N, Z>>) -> Self {
        Self {
            t: state.t,
            q: state.q.as_slice().to_vec(),
            v: state.v.as_slice().to_vec(),
        }
    }
}

/// An event that occurred.
#[derive(Clone, Debug, PartialEq)]
pub struct Found {
    /// The index of the event.
    pub event: usize,
    /// Whether its function rises.
    pub rises: bool,
    /// Where it occurred.
    pub at: Reached,
}

/// A motion, up to its end or to an error.
#[derive(Debug)]
pub struct Integrated {
    /// The samples.
    pub samples: Vec<Reached>,
    /// The events that were recorded, in the order of time.
    pub events: Vec<Found>,
    /// The last state.
    pub end: Reached,
    /// Why it is the last.
    pub reason: StopReason,
    /// How many steps were taken.
    pub steps: u64,
    /// The error that ended it.
    pub error: Option<IntegrationError>,
}

/// A solution with samples.
type Sampled<const N: usize, Z> = Solution<f64, Phase<f64, N, Z>, Vec<At<f64, Phase<f64, N, Z>>>>;

impl Integrated {
    pub(crate) fn of<Z, const N: usize>(
        solution: &Sampled<N, Z>,
        watch: &Watch,
        error: Option<IntegrationError>,
    ) -> Self {
        Self {
            samples: solution.samples().iter().map(Reached::of).collect(),
            events: found(solution.events(), watch),
            end: Reached::of(&solution.last),
            reason: solution.reason,
            steps: solution.statistics.steps,
            error,
        }
    }
}

/// The events that are kept: the first half of the watched ones are where functions rise, the others where they fall.
pub(crate) fn found<Z, const N: usize>(
    events: &[Occurrence<Phase<f64, N, Z>>],
    watch: &Watch,
) -> Vec<Found> {
    let count = watch.recorded.len() / 2;
    let kept = events.iter().filter(|event| watch.records(event.event));
    kept.map(|event| Found {
        event: event.event % count.max(1),
        rises: event.event < count,
        at: Reached::of(&event.state),
    })
    .collect()
}
