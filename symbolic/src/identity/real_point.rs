//! Random real points: signs, sizes, and numbers that coincide.
//!
//! One point in four has numbers near one, one has numbers of many sizes, one has some that are equal, small
//! integers and halves; in the fourth parameters are negative now and then. All are drawn from a seed by
//! splitmix64 (Steele, Lea and Flood, Fast splittable pseudorandom number generators, 2014), with another seed
//! than those of the modular points.

use crate::Symbol;
use crate::identity::residue::mix;

/// Different from the seeds of modular points, which count from 0.
const SEED: u64 = 0x5851_f42d_4c95_7f2d;

/// A random real point.
#[derive(Clone, Copy, Debug)]
pub(crate) struct RealPoint {
    seed: u64,
    distribution: Distribution,
}

/// The distribution of the coordinates of a point.
#[derive(Clone, Copy, PartialEq, Debug)]
enum Distribution {
    NearOne,
    ManySizes,
    Coinciding,
    NegativeParameters,
    Spread,
}

impl RealPoint {
    /// The point with this number.
    pub(crate) const fn new(number: u64) -> Self {
        let distribution = match number % 4 {
            0 => Distribution::NearOne,
            1 => Distribution::ManySizes,
            2 => Distribution::Coinciding,
            _ => Distribution::NegativeParameters,
        };
        Self {
            seed: mix(SEED, number),
            distribution,
        }
    }

    /// A point of numbers of either sign from 2⁻¹⁰ to 2¹⁰, for domains that are far away.
    pub(crate) const fn spread(number: u64) -> Self {
        Self {
            seed: mix(SEED, number),
            distribution: Distribution::Spread,
        }
    }

    /// The value of a symbol.
    pub(crate) fn value(self, symbol: Symbol) -> f64 {
        let word = self.word(symbol);
        let fraction = fraction(word);
        let size = match self.distribution {
            Distribution::NearOne | Distribution::NegativeParameters => 0.3 + 1.9 * fraction,
            Distribution::ManySizes => libm::exp2(10.0 * fraction - 5.0),
            Distribution::Spread => libm::exp2(20.0 * fraction - 10.0),
            Distribution::Coinciding => [0.5, 1.0, 1.5, 2.0, 2.5, 3.0][(word % 6) as usize],
        };
        let is_negative = match symbol {
            Symbol::Parameter(_) if self.distribution == Distribution::NegativeParameters => {
                word & 0x300 == 0
            }
            Symbol::Parameter(_) | Symbol::Invariant(_) => false,
            _ => word & 0x100 == 0,
        };
        if is_negative { -size } else { size }
    }

    /// A number between −1 and 1 that does not belong to a symbol.
    pub(crate) fn weight(self, kind: u64, index: usize) -> f64 {
        2.0 * fraction(mix(mix(self.seed, 1000 + kind), index as u64)) - 1.0
    }

    fn word(self, symbol: Symbol) -> u64 {
        let (kind, index) = symbol.code();
        mix(mix(self.seed, kind), index.into())
    }
}

/// A word as a number from 0 to 1.
#[allow(clippy::cast_precision_loss)] // Its upper half is enough.
fn fraction(word: u64) -> f64 {
    (word >> 32) as f64 / f64::from(u32::MAX)
}
