//! What an evaluation of the derived accelerations takes, beside the same written by hand.
//!
//! `cargo run --release -p lagrangian-bench` measures both in turn and prints one line a model. The
//! absolute figures move with the machine: the ratio is what counts. Each evaluation of the throughput
//! is of another state; in the latency each begins with the result of the one before.

mod models;

use std::hint::black_box;
use std::time::Instant;

use lagrangian::OperationCount;
use lagrangian::prelude::*;
use nalgebra::SVector;

use models::{DoublePendulum, GeneralTop, SymmetricTop};

const STATES: usize = 256;
const ROUNDS: usize = 40;
const REPEATS: usize = 400;

fn main() {
    println!(
        "{:<16} {:>10} {:>22} {:>22}",
        "", "", "throughput, ns", "latency, ns"
    );
    println!(
        "{:<16} {:>10} {:>9} {:>6} {:>5} {:>9} {:>6} {:>5}",
        "model", "operations", "derived", "hand", "ratio", "derived", "hand", "ratio"
    );
    let top = black_box(SymmetricTop {
        i: 1.2,
        i_s: 0.5,
        m: 1.3,
        g: 9.81,
        l: 0.4,
    });
    let derived = |state: &State<f64, 3>| top.accelerations(state);
    report(
        "symmetric top",
        SymmetricTop::OPERATIONS.accelerations,
        derived,
        |state| top.by_hand(state),
    );
    let top = black_box(GeneralTop {
        i1: 1.2,
        i2: 1.5,
        i3: 0.7,
        m: 1.3,
        g: 9.81,
        l: 0.4,
    });
    let derived = |state: &State<f64, 3>| top.accelerations(state);
    report(
        "general top",
        GeneralTop::OPERATIONS.accelerations,
        derived,
        |state| top.by_hand(state),
    );
    let pendulum = black_box(DoublePendulum {
        m: 1.1,
        g: 9.81,
        l: 0.7,
    });
    let derived = |state: &State<f64, 2>| pendulum.accelerations(state);
    report(
        "double pendulum",
        DoublePendulum::OPERATIONS.accelerations,
        derived,
        |state| pendulum.by_hand(state),
    );
}

/// Checks that two ways to compute accelerations agree, measures them in turn, and prints a line.
fn report<const N: usize>(
    name: &str,
    operations: OperationCount,
    derived: impl Fn(&State<f64, N>) -> SVector<f64, N>,
    by_hand: impl Fn(&State<f64, N>) -> SVector<f64, N>,
) {
    let states = states::<N>();
    for state in &states {
        let (derived, by_hand) = (derived(state), by_hand(state));
        let error = (derived - by_hand).norm() / by_hand.norm().max(1.0);
        assert!(error < 1e-11, "{name}: {derived} is not {by_hand}");
    }
    let mut best = [f64::INFINITY; 4];
    for _ in 0..ROUNDS {
        let times = [
            throughput(&states, &derived),
            throughput(&states, &by_hand),
            latency(&states, &derived),
            latency(&states, &by_hand),
        ];
        for (best, time) in best.iter_mut().zip(times) {
            *best = best.min(time);
        }
    }
    println!(
        "{name:<16} {:>10} {:>9.1} {:>6.1} {:>5.2} {:>9.1} {:>6.1} {:>5.2}",
        operations.total(),
        best[0],
        best[1],
        best[0] / best[1],
        best[2],
        best[3],
        best[2] / best[3],
    );
}

/// Nanoseconds for each of independent evaluations.
fn throughput<const N: usize>(
    states: &[State<f64, N>],
    accelerations: &impl Fn(&State<f64, N>) -> SVector<f64, N>,
) -> f64 {
    let start = Instant::now();
    for _ in 0..REPEATS / 10 {
        for state in states {
            black_box(accelerations(black_box(state)));
        }
    }
    per_evaluation(start, REPEATS / 10 * states.len())
}

/// Nanoseconds for each of evaluations in a chain.
fn latency<const N: usize>(
    states: &[State<f64, N>],
    accelerations: &impl Fn(&State<f64, N>) -> SVector<f64, N>,
) -> f64 {
    let mut state = states[0];
    let start = Instant::now();
    for _ in 0..REPEATS * 10 {
        // So little that the state stays where it is, and enough that the next evaluation waits.
        state.q += accelerations(&state) * 1e-18;
    }
    black_box(state);
    per_evaluation(start, REPEATS * 10)
}

#[allow(clippy::cast_precision_loss)] // Counts of some thousands.
fn per_evaluation(start: Instant, evaluations: usize) -> f64 {
    start.elapsed().as_secs_f64() * 1e9 / evaluations as f64
}

/// Pseudo-random states away from the poles, the same on every run.
fn states<const N: usize>() -> Vec<State<f64, N>> {
    let mut seed = 1_u64;
    let mut uniform = |low: f64, high: f64| {
        seed = seed
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        let bits = u32::try_from(seed >> 32).unwrap_or(0);
        low + (high - low) * f64::from(bits) / f64::from(u32::MAX)
    };
    (0..STATES)
        .map(|_| {
            let q = SVector::from_fn(|_, _| uniform(0.2, 2.9));
            let v = SVector::from_fn(|_, _| uniform(-3.0, 3.0));
            State::new(0.0, q, v)
        })
        .collect()
}
