//! Perturbations of intermediate results, which show how much rounding can matter (Monte Carlo arithmetic: Parker,
//! Monte Carlo Arithmetic: exploiting randomness in floating-point arithmetic, 1997).

use crate::identity::residue::mix;
use crate::limits::PERTURBATION;

/// How far the results of a run are moved, relative to their size; by nothing without a seed.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Perturbation(pub(crate) Option<u64>);

impl Perturbation {
    /// The factor of the result at a position.
    pub(crate) fn factor(self, position: usize) -> f64 {
        1.0 + PERTURBATION * self.random(position)
    }

    /// How far the result at a position is moved where it is below the smallest normal number: as many times the smallest
    /// number as [`factor`](Self::factor) moves others by rounding errors.
    pub(crate) fn shift(self, position: usize) -> f64 {
        f64::MIN_POSITIVE * PERTURBATION * self.random(position)
    }

    /// A random number between −1 and 1 for a position; 0 without a seed.
    #[allow(clippy::cast_precision_loss)] // Thirty-two bits are enough.
    fn random(self, position: usize) -> f64 {
        match self.0 {
            None => 0.0,
            Some(seed) => {
                let word = mix(seed, position as u64) >> 32;
                word as f64 / f64::from(u32::MAX) * 2.0 - 1.0
            }
        }
    }
}
