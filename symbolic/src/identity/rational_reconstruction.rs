//! Rationals from their residues (Wang, Guy and Davenport, p-adic reconstruction of rational numbers, 1982).

use crate::Rational;

/// The rational n/d with |n| and d below √(p/2) whose residue modulo the prime p is `value`, if there is one.
pub(crate) fn rational(value: u64, p: u64) -> Option<Rational> {
    let bound = (p / 2).isqrt();
    let (mut remainder, mut next) = (p, value);
    let (mut multiplier, mut next_multiplier) = (0_i128, 1_i128);
    while next > bound {
        let quotient = remainder / next;
        (remainder, next) = (next, remainder % next);
        (multiplier, next_multiplier) = (
            next_multiplier,
            multiplier - i128::from(quotient) * next_multiplier,
        );
    }
    let is_small = next_multiplier != 0 && next_multiplier.unsigned_abs() <= u128::from(bound);
    let denominator = i64::try_from(next_multiplier).ok().filter(|_| is_small)?;
    Rational::new(i64::try_from(next).ok()?, 1).and_then(|numerator| {
        let inverse = Rational::integer(denominator).reciprocal()?;
        Some(&numerator * &inverse)
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::identity::residue;

    #[test]
    fn small_rationals_are_found_again_and_random_residues_are_none() {
        let p = residue::Field::of(0).p;
        for (n, d) in [(0, 1), (1, 1), (-1, 1), (7, 3), (-12_345, 678_901)] {
            let numerator = residue::add(p, u64::try_from(n + 1_000_000).unwrap(), p);
            let numerator = residue::add(numerator, residue::negate(1_000_000, p), p);
            let inverse = residue::reciprocal(d, p).unwrap();
            let value = residue::multiply(numerator, inverse, p);
            let expected = Rational::new(n, i64::try_from(d).unwrap()).unwrap();
            assert_eq!(rational(value, p), Some(expected));
        }
    }
}
