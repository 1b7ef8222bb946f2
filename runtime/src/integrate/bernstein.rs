//! The Bernstein form of a polynomial on an interval, and the changes of sign in it.

use crate::scalar::Scalar;

/// Bound on the rounding errors of a coefficient, in machine epsilons times the number of terms, relative to the sum of
/// the magnitudes of all terms. The shift, the scaling and the sum of positive multiples each add one epsilon per term.
pub(crate) const ROUNDINGS: f64 = 4.0;

/// Replaces the coefficients of p by bᵢ = Σ C(i, k)/C(n, k) cₖ, where p(a + (b − a) s) = Σ cₖ sᵏ.
#[inline]
pub(crate) fn between<S: Scalar>(all: &mut [S], a: f64, b: f64) {
    let degree = all.len().saturating_sub(1);
    let (shift, width) = (S::from_f64(a), S::from_f64(b - a));
    if a != 0.0 {
        for i in 0..degree {
            for j in (i..degree).rev() {
                let upper = all[j + 1];
                all[j] += shift * upper;
            }
        }
    }
    // (b − a)ᵏ and 1/C(n, k) apart: where the degree is known to the compiler, so is the latter.
    let (mut power, mut weight) = (S::one(), S::one());
    for (k, coefficient) in all.iter_mut().enumerate().skip(1) {
        let [k, rest] = [k, degree + 1 - k].map(|number| S::from_f64(as_number(number)));
        power *= width;
        weight = weight * k / rest;
        *coefficient *= power * weight;
    }
    add_lower(all);
}

/// Adds to each number the lower one, as often as its index says.
#[inline]
fn add_lower<S: Scalar>(all: &mut [S]) {
    for i in 1..all.len() {
        let mut lower = all[i - 1];
        for place in &mut all[i..] {
            let present = *place;
            *place += lower;
            lower = present;
        }
    }
}

/// The sign changes of a sequence.
#[derive(Clone, Copy, Default)]
pub(crate) struct Variations {
    pub(crate) first: f64,
    pub(crate) last: f64,
    pub(crate) count: u32,
    /// Whether the sign of some term is uncertain.
    pub(crate) is_uncertain: bool,
}

impl Variations {
    pub(crate) fn of(values: impl Iterator<Item = f64>, least: f64) -> Self {
        let mut variations = Self::default();
        for value in values {
            variations.push(value, least);
        }
        variations
    }

    fn push(&mut self, value: f64, least: f64) {
        if value.abs() > least {
            let sign = value.signum();
            if self.count == 0 && self.last == 0.0 {
                self.first = sign;
            }
            self.count += u32::from(self.last * sign < 0.0);
            self.last = sign;
        } else {
            self.is_uncertain = true;
        }
    }
}

/// Converts a small integer to a floating-point number.
pub(crate) fn as_number(n: usize) -> f64 {
    f64::from(u32::try_from(n).unwrap_or(u32::MAX))
}
