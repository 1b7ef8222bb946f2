//! The real roots of a polynomial in the unit interval, one after the other.
//!
//! The signs of the Bernstein coefficients on an interval bound the number of roots there (Descartes' rule of signs: G.
//! E. Collins & A. G. Akritas, *Polynomial Real Root Isolation Using Descarte's Rule of Signs*, SYMSAC 1976; F.
//! Rouillier & P. Zimmermann, *Efficient isolation of polynomial's real roots*, J. Comput. Appl. Math. **162** (2004)
//! 33–50). Intervals are halved until the number is known. The arithmetic uses double-doubles, so that a sign is as
//! certain as the coefficients: values smaller than their rounding errors have no sign.

mod leaving;
#[cfg(test)]
mod tests;

use super::location::Bracket;
use crate::integrate::bernstein::{self, Variations, as_number};
use crate::limits::events::{
    DISPLACEMENTS, ISOLATION_STEPS, MAX_COEFFICIENTS, MIN_WIDTH, NEAR, UNCERTAINTY,
};
use crate::scalar::DoubleDouble;

/// The polynomial Σ aₖ uᵏ.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Polynomial {
    coefficients: [DoubleDouble; MAX_COEFFICIENTS],
    /// Bounds of the errors of the coefficients.
    errors: [f64; MAX_COEFFICIENTS],
    /// The rounding error of the constant, by which the whole function may be shifted.
    shift: f64,
    /// The number of coefficients.
    count: usize,
    /// The machine epsilon of the coefficients.
    epsilon: f64,
}

/// A root.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Root {
    /// The position of the root; the upper of two neighbouring numbers.
    pub(crate) at: f64,
    /// The sign before it.
    pub(crate) before: f64,
    /// The sign after it, which is equal to `before` if the polynomial touches zero.
    pub(crate) behind: f64,
    /// The argument from which the sign after the root is certain.
    pub(crate) until: f64,
}

/// The result of an inspection of the Bernstein coefficients on an interval.
enum Finding {
    /// The first root in the interval.
    Root(Root),
    /// The interval has to be halved.
    Unclear,
    /// The polynomial has no certain sign at the end of the interval, which has to be moved.
    UncertainEnd,
    /// There is no root in the interval; the sign at its end, or 0 if that is uncertain.
    NoRoot { last: f64 },
}

impl Polynomial {
    /// Creates the polynomial with these coefficients, whose relative errors are of the order of this machine epsilon.
    /// `None` if there are too many, or one is not finite.
    pub(crate) fn new(
        coefficients: impl Iterator<Item = DoubleDouble>,
        epsilon: f64,
    ) -> Option<Self> {
        let mut polynomial = Self {
            epsilon,
            ..Self::ZERO
        };
        for coefficient in coefficients {
            if !coefficient.to_f64().is_finite() {
                return None;
            }
            *polynomial.coefficients.get_mut(polynomial.count)? = coefficient;
            polynomial.errors[polynomial.count] =
                UNCERTAINTY * epsilon * coefficient.to_f64().abs();
            polynomial.count += 1;
        }
        Some(polynomial)
    }

    /// Creates the polynomial whose argument is the fraction of a length, from coefficients in powers of the argument
    /// in which the length is given. `None` under the conditions of [`new`](Self::new), or if a term overflows.
    pub(crate) fn over(
        coefficients: impl Iterator<Item = DoubleDouble>,
        length: f64,
        epsilon: f64,
    ) -> Option<Self> {
        let mut power = DoubleDouble::from(1.0);
        let scaled = coefficients.map(|coefficient| {
            // A high power may be infinite.
            let term = if coefficient == DoubleDouble::ZERO {
                coefficient
            } else {
                coefficient * power
            };
            power *= DoubleDouble::from(length);
            term
        });
        Self::new(scaled, epsilon)
    }

    /// The polynomial 0.
    pub(super) const ZERO: Self = Self {
        coefficients: [DoubleDouble::ZERO; MAX_COEFFICIENTS],
        errors: [0.0; MAX_COEFFICIENTS],
        shift: 0.0,
        count: 0,
        epsilon: 0.0,
    };

    /// Whether each of the last two terms is at most `part` times the sum of all terms, or a rounding error.
    pub(super) fn has_converged(&self, part: f64) -> bool {
        let sizes = self.coefficients().iter().map(|a| a.to_f64().abs());
        let least = part * sizes.clone().sum::<f64>();
        let pairs = sizes.zip(self.errors).skip(self.count.saturating_sub(2));
        pairs
            .into_iter()
            .all(|(size, error)| size <= least.max(error))
    }

    fn coefficients(&self) -> &[DoubleDouble] {
        self.coefficients.get(..self.count).unwrap_or_default()
    }

    /// Returns the polynomial without its constant, divided by u.
    pub(super) fn over_argument(mut self) -> Self {
        let count = self.count;
        if let Some(coefficients) = self.coefficients.get_mut(..count) {
            coefficients.rotate_left(1);
        }
        if let Some(errors) = self.errors.get_mut(..count) {
            errors.rotate_left(1);
        }
        (self.count, self.shift) = (count.saturating_sub(1), 0.0);
        self
    }

    /// Returns this polynomial with error bounds enlarged to the differences from another one, whose coefficients
    /// differ by rounding errors. An error of the constant shifts the function and makes no zeros; but from one window
    /// to the next, the sign of a function that is not larger than the shift means nothing.
    pub(super) fn compared_with(mut self, other: &Self) -> Self {
        let pairs = self.coefficients.iter().zip(&other.coefficients);
        for (error, (a, b)) in self.errors.iter_mut().zip(pairs).skip(1) {
            *error = error.max((*a - *b).to_f64().abs());
        }
        let difference = self.coefficients[0] - other.coefficients[0];
        self.shift_by(difference.to_f64().abs());
        self
    }

    /// Raises the possible error of the constant to at least `error`.
    pub(super) fn shift_by(&mut self, error: f64) {
        self.shift = self.shift.max(error);
    }

    /// Whether all terms but the constant are within the errors of the coefficients, so that there are no zeros.
    fn is_constant(&self) -> bool {
        let sizes = self.coefficients().iter().map(|a| a.to_f64().abs());
        let [sizes, errors] = [sizes.skip(1).sum::<f64>(), self.errors.iter().skip(1).sum()];
        sizes <= errors
    }

    /// Whether the constant exceeds the sum of the magnitudes of the other terms in the unit interval.
    pub(crate) fn has_one_sign(&self) -> bool {
        let mut sizes = self.coefficients().iter().map(|a| a.to_f64().abs());
        let constant = sizes.next().unwrap_or(0.0);
        constant > sizes.sum::<f64>() * (1.0 + UNCERTAINTY * self.epsilon)
    }

    /// Returns the value at `u`, by Horner's rule.
    fn value(&self, u: f64) -> f64 {
        let (u, zero) = (DoubleDouble::from(u), DoubleDouble::from(0.0));
        let coefficients = self.coefficients().iter().rev();
        coefficients.fold(zero, |sum, a| sum * u + *a).to_f64()
    }

    /// Whether the polynomial at `u` agrees with `value`, up to a small part of the terms and rounding errors.
    pub(super) fn is_near(&self, u: f64, value: f64) -> bool {
        let sum: f64 = self.coefficients().iter().map(|a| a.to_f64().abs()).sum();
        (self.value(u) - value).abs() <= NEAR * sum + self.uncertainty(u) + self.shift
    }

    /// Whether the root of the tangent at 0 is no farther away than `distance`, or the value at 0 is 0. This is false
    /// for the polynomial that is 0 everywhere.
    pub(super) fn is_zero_within(&self, distance: f64) -> bool {
        let mut sizes = self.coefficients().iter().map(|a| a.to_f64().abs());
        let [value, slope] = [sizes.next(), sizes.next()].map(|size| size.unwrap_or(0.0));
        let is_zero = value <= slope * distance || value <= 0.0;
        is_zero && sizes.fold(slope, f64::max) > 0.0
    }

    /// Returns the derivative at `u`.
    pub(super) fn slope(&self, u: f64) -> f64 {
        let (u, zero) = (DoubleDouble::from(u), DoubleDouble::from(0.0));
        let coefficients = self.coefficients().iter().enumerate().skip(1).rev();
        let sum = coefficients.fold(zero, |sum, (k, a)| sum * u + *a * number(k));
        sum.to_f64()
    }

    /// Returns the effect of the errors of the coefficients on a value up to `u`: a smaller value has no sign.
    fn uncertainty(&self, u: f64) -> f64 {
        let errors = self.errors.get(..self.count).unwrap_or_default();
        errors.iter().rev().fold(0.0, |sum, error| sum * u + error)
    }

    /// Returns the sign at `u`, if it has one that no shift of the function changes.
    pub(super) fn certain_sign(&self, u: f64) -> Option<f64> {
        let value = self.value(u);
        (value.abs() > self.uncertainty(u) + 2.0 * self.shift).then(|| value.signum())
    }

    /// Whether the value at `u` has no sign.
    pub(super) fn is_uncertain(&self, u: f64) -> bool {
        self.value(u).abs() <= self.uncertainty(u)
    }

    /// Returns the sign just after `u`, which lasts until the next root.
    pub(super) fn sign_behind(&self, u: f64, next: Option<Root>) -> f64 {
        if let Some(root) = next {
            return root.before;
        }
        let middle = 0.5 * (u + 1.0);
        let value = self.value(middle);
        if value.abs() > self.uncertainty(middle) + self.shift {
            value.signum()
        } else {
            0.0
        }
    }

    /// Returns the sign at 1, or close to 1 if it is not certain there; `otherwise` if it is not certain anywhere after
    /// `from`.
    pub(super) fn last_sign(&self, from: f64, otherwise: f64) -> f64 {
        let parts = (0..f64::MANTISSA_DIGITS).scan(f64::EPSILON, |part, _| {
            let u = 1.0 - *part;
            *part *= 2.0;
            Some(u)
        });
        let before = parts.take_while(|u| *u > from);
        let mut signs = core::iter::once(1.0)
            .chain(before)
            .filter_map(|u| self.certain_sign(u));
        signs.next().unwrap_or(otherwise)
    }

    /// Returns the first root after `from`, up to 1. If `from` follows another root, `sign` is the sign after that
    /// root.
    pub(crate) fn next_root(&self, from: f64, mut sign: f64) -> Option<Root> {
        if self.has_one_sign() || self.is_constant() {
            return None;
        }
        let (mut left, mut width) = (from, 1.0 - from);
        // The argument up to which the sign was certain.
        let mut until = from;
        let mut displaced = 0;
        for _ in 0..ISOLATION_STEPS {
            if left >= 1.0 {
                break;
            }
            let right = (left + width).min(1.0);
            width = right - left;
            let may_displace = displaced < DISPLACEMENTS;
            match self.look_between((left, right), (sign, until), may_displace) {
                Finding::Root(root) => return Some(root),
                Finding::Unclear => width *= 0.5,
                Finding::UncertainEnd => (width, displaced) = (0.7 * width, displaced + 1),
                Finding::NoRoot { last } => {
                    if last != 0.0 {
                        (sign, until) = (last, right);
                    }
                    (left, width) = (right, 2.0 * width);
                }
            }
        }
        None
    }

    /// Inspects an interval for its first root, given the sign before it and the argument up to which that was certain.
    fn look_between(
        &self,
        (left, right): (f64, f64),
        (sign, until): (f64, f64),
        may_displace: bool,
    ) -> Finding {
        let is_least = right - left <= MIN_WIDTH;
        let [values, slopes] = self.variations(left, right);
        if values.is_uncertain {
            let settled = is_least || self.uncertainty(right) <= 2.0 * self.uncertainty(left);
            if !settled {
                return Finding::Unclear;
            }
            // A zero at the end would be found from neither side.
            if right < 1.0 && may_displace && self.is_uncertain(right) {
                return Finding::UncertainEnd;
            }
        }
        if sign * values.first < 0.0 {
            let opposite = |u: &f64| sign * self.value(*u) < 0.0;
            if values.count > 0 && !is_least && !opposite(&left) {
                return Finding::Unclear;
            }
            let end = [left, 0.5 * (left + right)].into_iter().find(opposite);
            return Finding::Root(self.crossing(until, end.unwrap_or(right), right, sign));
        }
        let extremum = || self.at_extremum(left, right, values.first, slopes.first);
        let root = match values.count {
            0 => {
                // A zero of a higher even order, around which no coefficient is certain.
                let turns = values.first * slopes.first < 0.0 && values.first * slopes.last > 0.0;
                let touches = values.is_uncertain && turns && !self.is_uncertain(right);
                touches.then(extremum).flatten()
            }
            1 => Some(self.crossing(left, right, right, values.first)),
            _ if slopes.count == 1 => extremum(),
            _ if !is_least => return Finding::Unclear,
            _ => Some(Root {
                at: right,
                before: values.first,
                behind: values.last,
                until: right,
            }),
        };
        root.map_or(Finding::NoRoot { last: values.last }, Finding::Root)
    }

    /// Returns the first root in an interval that has one extremum, by the value there: there are two roots, one root
    /// that is double to within the errors of the coefficients, or none.
    fn at_extremum(&self, a: f64, b: f64, sign: f64, slope: f64) -> Option<Root> {
        let at = bisect(a, b, |u| slope * self.slope(u));
        let value = sign * self.value(at);
        let least = self.uncertainty(at);
        if value < -least && at > a {
            Some(self.crossing(a, at, at, sign))
        } else if value <= least {
            Some(Root {
                at,
                before: sign,
                behind: sign,
                until: self.certain(at, b, sign),
            })
        } else {
            None
        }
    }

    /// Returns the root between two arguments, at the first of which the polynomial has this sign. The opposite sign is
    /// certain at `end` at the latest.
    fn crossing(&self, a: f64, b: f64, end: f64, sign: f64) -> Root {
        let at = bisect(a, b, |u| sign * self.value(u));
        Root {
            at,
            before: sign,
            behind: -sign,
            until: self.certain(at, end, -sign),
        }
    }

    /// Returns the first argument between two at which a sign is certain; at the latest the second one.
    fn certain(&self, a: f64, b: f64, sign: f64) -> f64 {
        bisect(a, b, |u| self.uncertainty(u) - sign * self.value(u))
    }

    /// Returns the variations of the Bernstein coefficients on an interval, and of their differences, which belong to
    /// the derivative. Plain `f64` arithmetic is used if its rounding errors change no sign.
    fn variations(&self, a: f64, b: f64) -> [Variations; 2] {
        let least = self.uncertainty(b);
        let mut plain = [0.0; MAX_COEFFICIENTS];
        let plain = plain.get_mut(..self.count).unwrap_or_default();
        let mut sum = 0.0;
        for (place, a) in plain.iter_mut().zip(self.coefficients()).rev() {
            *place = a.to_f64();
            sum = sum * b + place.abs();
        }
        bernstein::between(plain, a, b);
        let rounding = bernstein::ROUNDINGS * sum * f64::EPSILON * as_number(self.count);
        let is_certain = |value: &f64| value.abs() > least + rounding;
        let differ = |pair: &[f64]| (pair[1] - pair[0]).abs() > 2.0 * rounding;
        if plain.iter().all(is_certain) && plain.windows(2).all(differ) {
            let differences = plain.windows(2).map(|pair| pair[1] - pair[0]);
            return [
                Variations::of(plain.iter().copied(), least),
                Variations::of(differences, 0.0),
            ];
        }
        let mut all = self.coefficients;
        let all = all.get_mut(..self.count).unwrap_or_default();
        bernstein::between(all, a, b);
        let differences = all.windows(2).map(|pair| (pair[1] - pair[0]).to_f64());
        [
            Variations::of(all.iter().map(|value| value.to_f64()), least),
            Variations::of(differences, 0.0),
        ]
    }
}

/// Returns the first number after the zero of a function that is positive at `a` and not at `b`.
fn bisect(a: f64, b: f64, function: impl Fn(f64) -> f64) -> f64 {
    let mut ends = [a, b].map(|u| (u, function(u)));
    let mut bracket = Bracket::new(a, b);
    while let Some(u) = bracket.divide(ends[0], ends[1]) {
        let value = function(u);
        ends[usize::from(value <= 0.0)] = (u, value);
    }
    ends[1].0
}

/// Converts a small integer to a double-double.
fn number(n: usize) -> DoubleDouble {
    DoubleDouble::from(as_number(n))
}
