//! A state whose number of coordinates is not part of its type.

use lagrangian::State;

use crate::numbers::vector;

/// A time with coordinates and velocities.
#[derive(Clone, Copy, Debug)]
pub struct Instant<'a> {
    /// The time.
    pub t: f64,
    /// The coordinates.
    pub q: &'a [f64],
    /// The velocities.
    pub v: &'a [f64],
}

impl Instant<'_> {
    /// The state. Components that are missing are NaN.
    #[must_use]
    pub fn state<const N: usize>(&self) -> State<f64, N> {
        State::new(self.t, vector(self.q), vector(self.v))
    }
}
