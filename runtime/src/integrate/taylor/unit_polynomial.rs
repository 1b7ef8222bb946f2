//! The sign changes of a polynomial in the unit interval.
//!
//! J. M. Lane & R. F. Riesenfeld, *Bounds on a Polynomial*, BIT **21** (1981) 112–117: a polynomial changes its sign at
//! most as often as its Bernstein coefficients do, and the coefficients on a part of the interval follow by subdivision
//! (de Casteljau). Parts are halved until each has at most one change. The arithmetic is plain `f64`: values below its
//! errors have no sign.

use crate::integrate::bernstein::{self, Variations, as_number};
use crate::integrate::event::Bracket;
use crate::limits::events::MAX_COEFFICIENTS;
use crate::limits::taylor::{ISOLATION_STEPS, MIN_PART, SIGN_UNCERTAINTY};

/// A polynomial with an argument from 0 to 1.
#[derive(Clone, Copy, Debug)]
pub(super) struct UnitPolynomial {
    /// The coefficients of powers.
    powers: Coefficients,
    /// The relative errors of the terms.
    epsilon: f64,
}

/// A sign change.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct SignChange {
    /// The first number after the change.
    pub(super) at: f64,
    /// The sign after the change.
    pub(super) behind: f64,
}

/// The coefficients of a polynomial, in powers or in the Bernstein form.
#[derive(Clone, Copy, Debug)]
struct Coefficients {
    values: [f64; MAX_COEFFICIENTS],
    count: usize,
}

impl Coefficients {
    fn get(&self) -> &[f64] {
        self.values.get(..self.count).unwrap_or_default()
    }

    fn get_mut(&mut self) -> &mut [f64] {
        self.values.get_mut(..self.count).unwrap_or_default()
    }

    /// Converts the coefficients of powers to Bernstein coefficients on the unit interval.
    fn to_bernstein(mut self) -> Self {
        bernstein::between(self.get_mut(), 0.0, 1.0);
        self
    }

    /// Returns the Bernstein coefficients on the part of the interval after `u`.
    fn behind(mut self, u: f64) -> Self {
        let count = self.count;
        let all = self.get_mut();
        for length in (1..count).rev() {
            for j in 0..length {
                all[j] += u * (all[j + 1] - all[j]);
            }
        }
        self
    }

    /// Returns the Bernstein coefficients on the part of the interval before `u`.
    fn before(mut self, u: f64) -> Self {
        let count = self.count;
        let all = self.get_mut();
        for i in 1..count {
            for j in (i..count).rev() {
                all[j] = all[j - 1] + u * (all[j] - all[j - 1]);
            }
        }
        self
    }

    /// Returns the first and the last certain sign, and the number of sign changes.
    fn signs(&self, uncertainty: f64) -> Variations {
        Variations::of(self.get().iter().copied(), uncertainty)
    }
}

impl UnitPolynomial {
    /// Creates the polynomial with these coefficients, whose relative errors are of the order of this machine epsilon.
    /// Coefficients beyond the highest order of any method are ignored.
    pub(super) fn new(coefficients: impl Iterator<Item = f64>, epsilon: f64) -> Self {
        let mut powers = Coefficients {
            values: [0.0; MAX_COEFFICIENTS],
            count: 0,
        };
        for (slot, coefficient) in powers.values.iter_mut().zip(coefficients) {
            *slot = coefficient;
            powers.count += 1;
        }
        Self {
            powers,
            epsilon: epsilon.max(f64::EPSILON),
        }
    }

    pub(super) fn coefficients(&self) -> &[f64] {
        self.powers.get()
    }

    /// Returns the effect of errors of the terms on a value up to `u`.
    pub(super) fn uncertainty(&self, u: f64) -> f64 {
        let coefficients = self.coefficients().iter().rev();
        let sum = coefficients.fold(0.0, |sum, a| sum * u + a.abs());
        SIGN_UNCERTAINTY * self.epsilon * sum
    }

    /// Returns the value at `u`.
    pub(super) fn value(&self, u: f64) -> f64 {
        let coefficients = self.coefficients().iter().rev();
        coefficients.fold(0.0, |sum, a| sum * u + a)
    }

    /// Returns the derivative at `u`.
    pub(super) fn slope(&self, u: f64) -> f64 {
        let coefficients = self.coefficients().iter().enumerate().skip(1).rev();
        coefficients.fold(0.0, |sum, (k, a)| sum * u + a * as_number(k))
    }

    /// Returns the sign changes, in order. Arguments that differ by `resolution` are not distinguished.
    pub(super) fn sign_changes(&self, resolution: f64) -> SignChanges<'_> {
        SignChanges {
            polynomial: self,
            resolution,
            bernstein: self.powers.to_bernstein(),
            left: 0.0,
            width: 1.0,
            sign: 0.0,
            certain: 0.0,
            steps: 0,
        }
    }

    /// Returns the first number after a change of `sign` between two arguments.
    fn change_between(&self, a: f64, b: f64, sign: f64) -> f64 {
        let value = |u| sign * self.value(u);
        let mut ends = [a, b].map(|u| (u, value(u)));
        let mut bracket = Bracket::new(a, b);
        while let Some(u) = bracket.divide(ends[0], ends[1]) {
            let there = value(u);
            ends[usize::from(there <= 0.0)] = (u, there);
        }
        ends[1].0
    }
}

/// An iterator over the sign changes of a polynomial.
pub(super) struct SignChanges<'a> {
    polynomial: &'a UnitPolynomial,
    resolution: f64,
    bernstein: Coefficients,
    /// The beginning of the next part.
    left: f64,
    width: f64,
    /// The last certain sign; 0 before there is one.
    sign: f64,
    /// The argument up to which it was certain.
    certain: f64,
    steps: u32,
}

impl SignChanges<'_> {
    /// Proceeds to the next part, and doubles the width.
    fn advance(&mut self, right: f64) {
        self.left = right;
        self.width *= 2.0;
    }

    /// Returns a change to the sign `behind`, up to `right`.
    fn change(&mut self, behind: f64, right: f64) -> SignChange {
        let before = if self.sign == 0.0 { -behind } else { self.sign };
        let at = self.polynomial.change_between(self.certain, right, before);
        (self.sign, self.certain) = (behind, right);
        SignChange { at, behind }
    }
}

impl Iterator for SignChanges<'_> {
    type Item = SignChange;

    fn next(&mut self) -> Option<SignChange> {
        while self.left < 1.0 && self.steps < ISOLATION_STEPS {
            self.steps += 1;
            let right = (self.left + self.width).min(1.0);
            let part = if right - self.left >= 1.0 {
                self.bernstein
            } else {
                let rest = self.bernstein.behind(self.left);
                rest.before((right - self.left) / (1.0 - self.left))
            };
            let signs = part.signs(self.polynomial.uncertainty(right));
            let from_before = self.sign * signs.first < 0.0;
            let changes = signs.count + u32::from(from_before);
            let least = self.resolution.max(MIN_PART * self.left);
            if changes > 1 && right - self.left > least {
                self.width = 0.5 * (right - self.left);
                continue;
            }
            self.advance(right);
            if signs.last == 0.0 {
                continue;
            }
            let start = self.sign;
            if changes > 0 && start * signs.last <= 0.0 && (start != 0.0 || signs.count % 2 == 1) {
                return Some(self.change(signs.last, right));
            }
            (self.sign, self.certain) = (signs.last, right);
        }
        None
    }
}

#[cfg(test)]
mod tests {
    use super::UnitPolynomial;

    /// Returns the coefficients of Π (u − rᵢ).
    fn with_roots(roots: &[f64]) -> Vec<f64> {
        let mut coefficients = vec![1.0];
        for root in roots {
            let mut product = vec![0.0; coefficients.len() + 1];
            for (k, a) in coefficients.iter().enumerate() {
                product[k] -= root * a;
                product[k + 1] += a;
            }
            coefficients = product;
        }
        coefficients
    }

    fn check(roots: &[f64], expected: &[f64], tolerance: f64) {
        let polynomial = UnitPolynomial::new(with_roots(roots).into_iter(), f64::EPSILON);
        let found: Vec<_> = polynomial
            .sign_changes(1e-15)
            .map(|change| change.at)
            .collect();
        assert_eq!(found.len(), expected.len(), "{roots:?}: {found:?}");
        for (found, expected) in found.iter().zip(expected) {
            assert!((found - expected).abs() <= tolerance, "{roots:?}: {found}");
        }
    }

    #[test]
    fn changes_of_sign_are_found_in_order() {
        check(&[0.3], &[0.3], 1e-15);
        check(&[0.5], &[0.5], 1e-15);
        check(&[0.9, 0.1, 0.25], &[0.1, 0.25, 0.9], 1e-13);
        check(&[0.5, 0.25, 0.75, 0.125], &[0.125, 0.25, 0.5, 0.75], 1e-12);
        check(&[-0.5, 1.5, 0.7, 3.0], &[0.7], 1e-14);
        check(&[-0.5, 1.5, 3.0], &[], 0.0);
        check(&[0.5, 0.500_001], &[0.5, 0.500_001], 1e-10);
        check(&[0.0, 0.5], &[0.5], 1e-15);
    }

    #[test]
    fn where_zero_is_touched_no_sign_changes() {
        check(&[0.5, 0.5], &[], 0.0);
        check(&[0.3, 0.3, 0.3, 0.3], &[], 0.0);
        check(&[0.3, 0.3, 0.3], &[0.3], 1e-4);
        check(&[0.7, 0.3, 0.3], &[0.7], 1e-13);
    }

    #[test]
    fn slopes_are_derivatives() {
        let polynomial = UnitPolynomial::new([1.0, 2.0, 3.0, 4.0].into_iter(), f64::EPSILON);
        assert!((polynomial.slope(0.5) - (2.0 + 3.0 + 3.0)).abs() < 1e-14);
        assert!((polynomial.value(0.5) - (1.0 + 1.0 + 0.75 + 0.5)).abs() < 1e-14);
    }
}
