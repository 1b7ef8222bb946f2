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

/// A number that is no sum.
pub(crate) const fn exact(total: f64) -> SumWithSize {
    SumWithSize {
        total,
        size: total.abs(),
    }
}

/// Adds other sums to sums, each with this sign.
pub(crate) fn add_each(sums: &mut [SumWithSize], sign: f64, others: &[SumWithSize]) {
    for (sum, other) in sums.iter_mut().zip(others) {
        sum.total += sign * other.total;
        sum.size += other.size;
    }
}
