//! The values of event functions.

use super::met_conditions::MetConditions;

/// The values of one event function or of several.
pub trait Values: Copy {
    /// All values zero.
    const ZERO: Self;

    /// The number of values.
    const COUNT: usize;

    /// Returns the values.
    fn as_slice(&self) -> &[f64];

    /// Returns the values for modification.
    fn as_mut_slice(&mut self) -> &mut [f64];
}

impl Values for f64 {
    const ZERO: Self = 0.0;
    const COUNT: usize = 1;

    fn as_slice(&self) -> &[f64] {
        core::slice::from_ref(self)
    }

    fn as_mut_slice(&mut self) -> &mut [f64] {
        core::slice::from_mut(self)
    }
}

impl<const K: usize> Values for [f64; K] {
    const ZERO: Self = {
        assert!(K <= MetConditions::MAX, "at most 64 conditions at a time");
        [0.0; K]
    };
    const COUNT: usize = K;

    fn as_slice(&self) -> &[f64] {
        self
    }

    fn as_mut_slice(&mut self) -> &mut [f64] {
        self
    }
}
