//! Random numbers for tests, the same in every run.
#![allow(clippy::cast_precision_loss, reason = "numbers below 2⁵³")]

/// xorshift64 (G. Marsaglia, *Xorshift RNGs*, J. Stat. Softw. **8** (2003) 14).
pub(crate) struct Random(pub(crate) u64);

impl Random {
    fn next(&mut self) -> u64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        self.0
    }

    /// A number below n.
    pub(crate) fn below(&mut self, n: u16) -> u16 {
        u16::try_from((self.next() >> 11) % u64::from(n)).unwrap_or_default()
    }

    /// One of the multiples of 1/64 in [−1, 1].
    pub(crate) fn dyadic(&mut self) -> f64 {
        (f64::from(self.below(129)) - 64.0) / 64.0
    }

    /// A number in [0, 1).
    pub(crate) fn uniform(&mut self) -> f64 {
        (self.next() >> 11) as f64 * 2.0_f64.powi(-53)
    }
}
