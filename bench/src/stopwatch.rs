//! How long an evaluation takes.

use std::hint::black_box;
use std::time::{Duration, Instant};

use nalgebra::SVector;

use crate::evaluation::Evaluation;

/// So long is measured at once: long against the clock's resolution, short against interruptions.
const SLICE: Duration = Duration::from_micros(500);

/// So little that a state stays what it is, bit by bit, and enough that the next evaluation waits.
const NUDGE: f64 = 1e-300;

/// One side with its states, and the fastest that was seen of it.
pub(crate) struct Stopwatch<E: Evaluation<N>, const N: usize> {
    side: E,
    states: Vec<E::State>,
    /// How often to go through the states in one slice.
    repeats: u32,
    throughput: f64,
    latency: f64,
}

/// What can be measured in turn with others.
pub(crate) trait Measured {
    /// Measures once.
    fn round(&mut self);

    /// The fastest of all rounds: throughput and latency in nanoseconds.
    fn fastest(&self) -> (f64, f64);

    /// The accelerations at the states.
    fn accelerations(&self) -> Vec<Vec<f64>>;
}

impl<E: Evaluation<N>, const N: usize> Stopwatch<E, N> {
    pub(crate) fn new(side: E, rows: &[Vec<f64>]) -> Self {
        Self {
            side,
            states: rows.iter().map(|row| E::state(row)).collect(),
            repeats: 1,
            throughput: f64::INFINITY,
            latency: f64::INFINITY,
        }
    }

    /// Evaluations that do not depend on each other.
    fn independent(&self) -> Duration {
        let mut accelerations = SVector::zeros();
        let start = Instant::now();
        for _ in 0..self.repeats {
            for state in &self.states {
                self.side.evaluate(state, &mut accelerations);
                black_box(&mut accelerations);
            }
        }
        start.elapsed()
    }

    /// Evaluations each of which begins with the result of the one before.
    fn chained(&self) -> Duration {
        let mut accelerations = SVector::zeros();
        let start = Instant::now();
        for _ in 0..self.repeats {
            for state in &self.states {
                let state = E::moved(state, &(accelerations * NUDGE));
                self.side.evaluate(&state, &mut accelerations);
            }
        }
        black_box(accelerations);
        start.elapsed()
    }

    #[allow(clippy::cast_precision_loss)] // Counts of some thousands.
    fn nanoseconds(&self, slice: Duration) -> f64 {
        slice.as_secs_f64() * 1e9 / (f64::from(self.repeats) * self.states.len() as f64)
    }
}

impl<E: Evaluation<N>, const N: usize> Measured for Stopwatch<E, N> {
    fn round(&mut self) {
        // The side before has had the caches and the branch predictor for itself.
        while self.independent() < SLICE {
            self.repeats *= 2;
        }
        self.throughput = self.throughput.min(self.nanoseconds(self.independent()));
        self.latency = self.latency.min(self.nanoseconds(self.chained()));
    }

    fn fastest(&self) -> (f64, f64) {
        (self.throughput, self.latency)
    }

    fn accelerations(&self) -> Vec<Vec<f64>> {
        let mut accelerations = SVector::zeros();
        let evaluate = |state| {
            self.side.evaluate(state, &mut accelerations);
            accelerations.as_slice().to_vec()
        };
        self.states.iter().map(evaluate).collect()
    }
}
