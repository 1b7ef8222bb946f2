//! Sums with the magnitudes of their terms, which measure cancellation.

/// A sum that may cancel, and the sizes of its terms.
#[derive(Clone, Copy, Default)]
pub(crate) struct SumWithSize {
    pub(crate) total: f64,
    pub(crate) size: f64,
}

impl SumWithSize {
    pub(crate) fn add(&mut self, term: f64) {
        self.total += term;
        self.size += term.abs();
    }
}
