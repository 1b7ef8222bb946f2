//! Several motions in one scalar, and rows of numbers as their states.

use lagrangian::prelude::*;
use lagrangian::{DoubleDouble, Lanes};

/// How many motions are integrated at once.
pub const LANES: usize = 8;

/// A scalar that holds the numbers of some motions.
pub(crate) trait Motions: Scalar {
    const COUNT: usize;

    fn new(number: impl Fn(usize) -> f64) -> Self;

    fn number(self, motion: usize) -> f64;
}

impl Motions for f64 {
    const COUNT: usize = 1;

    fn new(number: impl Fn(usize) -> f64) -> Self {
        number(0)
    }

    fn number(self, _: usize) -> f64 {
        self
    }
}

impl Motions for DoubleDouble {
    const COUNT: usize = 1;

    fn new(number: impl Fn(usize) -> f64) -> Self {
        number(0).into()
    }

    fn number(self, _: usize) -> f64 {
        self.to_f64()
    }
}

impl Motions for Lanes<LANES> {
    const COUNT: usize = LANES;

    fn new(number: impl Fn(usize) -> f64) -> Self {
        Self::from_fn(number)
    }

    fn number(self, motion: usize) -> f64 {
        self.lane(motion)
    }
}

/// The state of some motions whose coordinates and velocities are rows.
pub(crate) fn state<S: Motions, const N: usize>(starts: &[Vec<f64>]) -> State<S, N> {
    let component = |index: usize| S::new(|motion| starts[motion][index]);
    State::new(
        S::zero(),
        SVector::from_fn(|i, _| component(i)),
        SVector::from_fn(|i, _| component(N + i)),
    )
}

/// The rows of some motions.
pub(crate) fn rows<S: Motions, const N: usize>(phase: &Phase<S, N>) -> Vec<Vec<f64>> {
    let row = |motion| {
        let components = phase.q.iter().chain(phase.v.iter());
        components
            .map(|component| component.number(motion))
            .collect()
    };
    (0..S::COUNT).map(row).collect()
}
