//! Numbers that look random and are the same on every run.

use lagrangian::State;

/// Marsaglia's xorshift with 64 bits, from the seed of his paper.
#[derive(Clone, Debug)]
pub struct Random(u64);

impl Default for Random {
    fn default() -> Self {
        Self(88_172_645_463_325_252)
    }
}

impl Random {
    /// A number between two others.
    #[allow(clippy::cast_precision_loss)] // 53 bits are kept.
    pub fn between(&mut self, low: f64, high: f64) -> f64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        low + (high - low) * ((self.0 >> 11) as f64 / (1_u64 << 53) as f64)
    }

    /// Numbers between two others.
    pub fn array<const N: usize>(&mut self, low: f64, high: f64) -> [f64; N] {
        std::array::from_fn(|_| self.between(low, high))
    }

    /// A state with angles from −3 to 3 and velocities from −2 to 2, its time from 0 to 1.
    pub fn state<const N: usize>(&mut self) -> State<f64, N> {
        State::new(
            self.between(0.0, 1.0),
            self.array(-3.0, 3.0),
            self.array(-2.0, 2.0),
        )
    }
}
