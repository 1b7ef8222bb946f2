//! Integrations by several programs, measured in turn.
//!
//! The machine is noisy: what runs beside us changes from one moment to the next. So all integrations of a contest run
//! one after the other, round after round, and the fastest run of each counts, in CPU time of its thread.

use std::time::{Duration, Instant};

use lagrangian_bench::{Integrated, Integration};

use crate::contestant::Contestant;

/// A run shorter than this is repeated until it is that long.
const AT_LEAST: f64 = 0.02;

/// An integration of one contestant.
#[derive(Clone, Debug)]
pub(crate) struct Entry {
    /// Which of the contestants.
    pub(crate) side: usize,
    pub(crate) integration: Integration,
    /// What the first round says, with the fewest seconds of all rounds. None where the contestant says that it cannot.
    pub(crate) result: Option<Integrated>,
}

impl Entry {
    pub(crate) fn new(side: usize, method: &str, starts: &[Vec<f64>], end: f64) -> Self {
        Self {
            side,
            integration: Integration {
                method: method.to_owned(),
                tolerance: None,
                starts: starts.to_vec(),
                end,
                at_least: AT_LEAST,
            },
            result: None,
        }
    }

    pub(crate) fn with_tolerance(mut self, tolerance: f64) -> Self {
        self.integration.tolerance = Some(tolerance);
        self
    }

    /// The fewest seconds, not a number where there is no result.
    pub(crate) fn seconds(&self) -> f64 {
        let result = self.result.as_ref();
        result.map_or(f64::NAN, |result| result.seconds)
    }
}

/// How long a contest goes on.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Rounds {
    pub(crate) least: usize,
    pub(crate) most: usize,
    /// No round begins after that.
    pub(crate) time: Duration,
}

impl Rounds {
    pub(crate) fn new(quick: bool) -> Self {
        Self {
            least: if quick { 1 } else { 4 },
            most: if quick { 3 } else { 60 },
            time: Duration::from_secs(if quick { 2 } else { 25 }),
        }
    }
}

/// Fills in the results. Before the first round, everything has run once, so that nothing is compiled or loaded there.
pub(crate) fn run(contestants: &mut [Contestant], entries: &mut [Entry], rounds: Rounds) {
    for entry in entries.iter_mut() {
        let contestant = &mut contestants[entry.side];
        let first = Integration {
            at_least: 0.0,
            ..entry.integration.clone()
        };
        match contestant.integrate(&first) {
            Ok(result) => entry.result = Some(result),
            Err(error) => eprintln!("{}: {error}", entry.integration.method),
        }
    }
    let start = Instant::now();
    for round in 0..rounds.most {
        if round >= rounds.least && start.elapsed() > rounds.time {
            break;
        }
        for entry in entries.iter_mut() {
            let Some(result) = &mut entry.result else {
                continue;
            };
            if let Ok(again) = contestants[entry.side].integrate(&entry.integration) {
                result.seconds = result.seconds.min(again.seconds);
            }
        }
    }
}
