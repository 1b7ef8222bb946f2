//! Designs: which probabilities the parameters of the members have.

use std::fmt;

use rand::seq::SliceRandom as _;
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::{Rng as _, SeedableRng as _};
use sobol::Sobol;
use sobol::params::JoeKuoD6;

use crate::error::Error;
use crate::limits::{MAX_HALTON_DIMENSION, MAX_SOBOL_DIMENSION};

/// A design of experiments in the unit cube.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Design {
    Random,
    LatinHypercube,
    Sobol,
    Halton,
}

/// A design with its seed.
#[derive(Clone, Debug)]
pub(super) enum Prepared {
    Random(ChaCha8Rng),
    /// The part of each member, for each parameter, and the position within it.
    LatinHypercube(Vec<Vec<u32>>, ChaCha8Rng),
    /// The direction numbers and the digital shift of each parameter.
    Sobol(Vec<Vec<u64>>, Vec<u64>),
    /// The base and the shift of each parameter.
    Halton(Vec<(u8, f64)>),
}

/// The stream of the generator from which a design is shifted and shuffled; those below are of the members.
const OF_DESIGN: u64 = u64::MAX;

/// The digits of a number of Sobol's sequence that are used: so many, and half a unit of the last, are exact.
const DIGITS: usize = 52;

impl Design {
    /// Returns an error if there is no such design.
    pub(super) fn check(self, count: usize, dimension: usize) -> Result<(), Error> {
        let limit = match self {
            Self::LatinHypercube if u32::try_from(count).is_err() => {
                let text = format!(
                    "a Latin hypercube has at most {} members, not {count}",
                    u32::MAX
                );
                return Err(Error::Points(text));
            }
            Self::Random | Self::LatinHypercube => return Ok(()),
            Self::Sobol => MAX_SOBOL_DIMENSION,
            Self::Halton => MAX_HALTON_DIMENSION,
        };
        if dimension > limit {
            let text = format!(
                "a {self} has at most {limit} parameters, not {dimension}; use a Latin hypercube"
            );
            return Err(Error::Points(text));
        }
        Ok(())
    }

    pub(super) fn prepare(self, count: usize, dimension: usize, seed: u64) -> Prepared {
        let members = ChaCha8Rng::seed_from_u64(seed);
        let mut generator = members.clone();
        generator.set_stream(OF_DESIGN);
        match self {
            Self::Random => Prepared::Random(members),
            Self::LatinHypercube => {
                let parts = (0..dimension).map(|_| {
                    let mut parts: Vec<u32> = (0..=u32::MAX).take(count).collect();
                    parts.shuffle(&mut generator);
                    parts
                });
                Prepared::LatinHypercube(parts.collect(), members)
            }
            Self::Sobol => {
                let numbers = JoeKuoD6::standard();
                let dimension = dimension.min(MAX_SOBOL_DIMENSION);
                let directions = Sobol::<f64>::init_direction_vals(dimension, DIGITS, &numbers);
                let shifts = (0..dimension).map(|_| generator.next_u64()).collect();
                Prepared::Sobol(directions, shifts)
            }
            Self::Halton => {
                let bases = (2..=u8::MAX).filter(|n| (2..*n).all(|divisor| n % divisor != 0));
                let bases = bases.take(dimension);
                Prepared::Halton(bases.map(|base| (base, uniform(&mut generator))).collect())
            }
        }
    }
}

impl Prepared {
    /// Writes the probabilities of the parameters of a member, each between 0 and 1.
    #[allow(clippy::cast_precision_loss)] // Indices and parts are below 2³².
    pub(super) fn probabilities(&self, index: usize, probabilities: &mut [f64]) {
        match self {
            Self::Random(members) => {
                let mut member = of_member(members, index);
                probabilities.fill_with(|| uniform(&mut member));
            }
            Self::LatinHypercube(parts, members) => {
                let mut member = of_member(members, index);
                for (probability, parts) in probabilities.iter_mut().zip(parts) {
                    let part = f64::from(parts[index]);
                    let probability_of_part = (part + uniform(&mut member)) / parts.len() as f64;
                    *probability = probability_of_part.min(1.0 - f64::EPSILON);
                }
            }
            Self::Sobol(directions, shifts) => {
                // Antonov and Saleev (1979): the digits of the Gray code choose the direction numbers.
                let code = index as u64 ^ (index as u64 >> 1);
                let shifted = directions.iter().zip(shifts);
                for (probability, (directions, shift)) in probabilities.iter_mut().zip(shifted) {
                    let digits = directions.iter().enumerate();
                    let chosen = digits.filter(|(digit, _)| code >> digit & 1 == 1);
                    let number = chosen.fold(*shift, |number, (_, direction)| number ^ direction);
                    *probability = in_unit_interval(number);
                }
            }
            Self::Halton(bases) => {
                for (probability, (base, shift)) in probabilities.iter_mut().zip(bases) {
                    let sum = halton::number(*base, index + 1) + shift;
                    *probability = if sum < 1.0 { sum } else { sum - 1.0 }.max(f64::MIN_POSITIVE);
                }
            }
        }
    }
}

/// Returns the generator of a member.
fn of_member(generator: &ChaCha8Rng, index: usize) -> ChaCha8Rng {
    let mut member = generator.clone();
    member.set_stream(index as u64);
    member
}

fn uniform(generator: &mut ChaCha8Rng) -> f64 {
    in_unit_interval(generator.next_u64())
}

/// Converts the leading digits to a number between 0 and 1, never one of the two.
#[allow(clippy::cast_precision_loss)] // 52 digits are exact.
fn in_unit_interval(number: u64) -> f64 {
    let digits = number >> (u64::BITS as usize - DIGITS);
    (digits as f64 + 0.5) / (1_u64 << DIGITS) as f64
}

impl fmt::Display for Design {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Random => "random sample",
            Self::LatinHypercube => "Latin hypercube",
            Self::Sobol => "Sobol sequence",
            Self::Halton => "Halton sequence",
        })
    }
}
