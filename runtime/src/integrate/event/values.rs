//! The values of event functions.

/// The values of one event function or of several.
pub trait Values: Copy {
    /// As many zeros.
    const ZERO: Self;

    /// The values.
    fn as_slice(&self) -> &[f64];

    /// The values, to be set.
    fn as_mut_slice(&mut self) -> &mut [f64];
}

impl Values for f64 {
    const ZERO: Self = 0.0;

    fn as_slice(&self) -> &[f64] {
        core::slice::from_ref(self)
    }

    fn as_mut_slice(&mut self) -> &mut [f64] {
        core::slice::from_mut(self)
    }
}

impl<const K: usize> Values for [f64; K] {
    const ZERO: Self = {
        assert!(K <= 64, "at most 64 conditions at a time");
        [0.0; K]
    };

    fn as_slice(&self) -> &[f64] {
        self
    }

    fn as_mut_slice(&mut self) -> &mut [f64] {
        self
    }
}
