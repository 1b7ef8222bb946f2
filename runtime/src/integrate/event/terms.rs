//! The terms of the Taylor polynomial of an event function in a step, or the first few, and the sign that they prove.
//!
//! For 0 ≤ u ≤ 1, Σ aₖ uᵏ differs from a₀ by at most Σ |aₖ|, k ≥ 1, and lies between its least and its greatest
//! Bernstein coefficient (G. T. Cargo & O. Shisha, *The Bernstein form of a polynomial*, J. Res. Nat. Bur. Standards
//! **70B** (1966) 79–81).

use crate::integrate::bernstein::{self, ROUNDINGS, Variations};
use crate::integrate::taylor::TaylorCoefficients;
use crate::limits::events::{LEADING_HALF_ORDER, MAX_COEFFICIENTS, NEAR, UNCERTAINTY};
use crate::linalg::horner;
use crate::scalar::{Lanes, Scalar};

/// The terms aₖ of a function up to the order 2·`HALF`, at the end of the step: in one motion, or in lanes.
pub(crate) struct Terms<S, const HALF: usize> {
    first: S,
    /// The terms of order 1 and higher.
    higher: [[S; 2]; HALF],
    /// The sum of the magnitudes of the higher terms.
    sum: S,
    /// The machine epsilon of the coefficients.
    epsilon: f64,
    /// The number of all terms of the series.
    count: f64,
}

impl<S: Scalar, const HALF: usize> Terms<S, HALF> {
    /// Returns the terms at the end of a step of this length, given the machine epsilon of the coefficients and the number of
    /// coefficients of the whole series.
    #[inline]
    pub(crate) fn new(
        coefficients: &TaylorCoefficients<S, HALF>,
        length: S,
        (epsilon, count): (f64, f64),
    ) -> Self {
        let mut terms = Self {
            first: *coefficients.initial(),
            higher: [[S::zero(); 2]; HALF],
            sum: S::zero(),
            epsilon: epsilon.max(f64::EPSILON),
            count,
        };
        let mut power = S::one();
        let places = terms.higher.as_flattened_mut();
        for (place, coefficient) in places.iter_mut().zip(coefficients.higher()) {
            power *= length;
            *place = *coefficient * power;
            terms.sum += place.abs();
        }
        terms
    }

    /// Bounds the contribution of further terms, assuming that none is larger than the last ones.
    #[inline]
    pub(crate) fn tail(&self) -> S {
        let [a, b] = self.higher.last().map_or([S::zero(); 2], |last| *last);
        S::from_f64(self.count) * Scalar::max(a.abs(), b.abs())
    }

    /// Bounds the effect of rounding on the terms.
    #[inline]
    pub(crate) fn rounding(&self) -> S {
        let part = (UNCERTAINTY + ROUNDINGS * self.count) * self.epsilon;
        S::from_f64(part) * (self.sum + self.first.abs())
    }

    /// Returns the sum of the magnitudes of the higher terms.
    #[inline]
    pub(super) fn sum(&self) -> S {
        self.sum
    }

    /// Returns the term of order 0, the value at the beginning of the step.
    #[inline]
    pub(super) fn first(&self) -> S {
        self.first
    }

    /// Returns the magnitude that a value has to exceed to have a sign: rounding errors, the contribution of further terms,
    /// and this part of the first term.
    #[inline]
    pub(super) fn least(&self, kept: f64) -> S {
        self.tail() + self.rounding() + S::from_f64(kept) * self.first.abs()
    }

    /// Returns by how much the first term exceeds all others: a positive number excludes zeros.
    #[inline]
    pub(crate) fn margin(&self, kept: f64) -> S {
        self.first.abs() - (self.sum + self.least(kept))
    }

    /// Returns the value of the polynomial at a fraction of the step.
    #[inline]
    pub(super) fn value(&self, u: S) -> S {
        let [value, _] = self.value_and_slope(u);
        value
    }

    /// Returns the value of the polynomial at a fraction of the step, and its derivative with respect to the fraction.
    #[inline]
    pub(super) fn value_and_slope(&self, u: S) -> [S; 2] {
        let pairs = self.higher.iter().map(<[S; 2]>::each_ref);
        let plus = |x: &S, u: S, y: &S| *x + u * *y;
        let [change, slope] = horner::change_and_derivative(pairs, u, S::zero(), plus);
        [self.first + change, slope]
    }

    /// Copies all terms.
    #[inline]
    fn copy_to(&self, all: &mut [S]) {
        let terms = core::iter::once(&self.first).chain(self.higher.as_flattened());
        for (place, term) in all.iter_mut().zip(terms) {
            *place = *term;
        }
    }

    /// Returns by how much a value of the function may differ from the polynomial: further terms and a small part of the terms.
    #[inline]
    pub(super) fn allowed(&self) -> S {
        self.tail() + S::from_f64(NEAR) * (self.sum + self.first.abs())
    }

    /// Returns by how much the polynomial at the end of the step differs from `value` beyond what is allowed: a positive number
    /// shows that it is not the function.
    #[inline]
    pub(crate) fn difference_at_end(&self, value: S) -> S {
        (self.value(S::one()) - value).abs() - self.allowed()
    }
}

impl<const HALF: usize> Terms<f64, HALF> {
    /// Returns the number of sign changes of the Bernstein coefficients between two fractions of the step, if they are certain
    /// and keep this part of the first term away from zero. If it is 0, the function keeps its sign there; if it is 1, it has one
    /// zero (Descartes' rule of signs: G. E. Collins & A. G. Akritas, *Polynomial Real Root Isolation Using Descarte's Rule of
    /// Signs*, SYMSAC 1976).
    #[inline]
    pub(super) fn sign_changes(&self, [from, to]: [f64; 2], kept: f64) -> Option<u32> {
        if self.margin(kept) > 0.0 {
            return Some(0);
        }
        let mut all = [0.0; MAX_COEFFICIENTS];
        let all = all.get_mut(..=2 * HALF)?;
        self.copy_to(all);
        bernstein::between(all, from, to);
        let variations = Variations::of(all.iter().copied(), self.least(kept));
        (!variations.is_uncertain).then_some(variations.count)
    }

    /// Whether the signs at both ends of the step are certain.
    pub(super) fn are_certain_at_ends(&self) -> bool {
        let least = self.least(0.0);
        self.first.abs() > least && self.value(1.0).abs() > least
    }

    /// Returns the sign in the whole step, if it is certain.
    pub(crate) fn sign(&self, kept: f64) -> Option<f64> {
        let keeps = self.sign_changes([0.0, 1.0], kept)? == 0;
        keeps.then(|| self.first.signum())
    }

    /// Whether the polynomial agrees with the value at the end of the step, up to further terms and a small part of the terms.
    pub(crate) fn ends_near(&self, value: f64) -> bool {
        self.difference_at_end(value) <= 0.0
    }
}

impl<const L: usize> Terms<Lanes<L>, LEADING_HALF_ORDER> {
    /// Returns the sign that the function has in the whole step of each lane, as [`sign`](Terms::sign) does; 0 if it is not
    /// certain.
    #[inline]
    pub(crate) fn sign_of_lanes(&self, kept: f64) -> [f64; L] {
        let margin = self.margin(kept);
        if margin.0.iter().all(|margin| *margin > 0.0) {
            return self.first.0.map(f64::signum);
        }
        self.signs_by_coefficients(margin, self.least(kept))
    }

    /// Returns the signs in all lanes, by Bernstein coefficients in lanes without a margin; 0 where the sign is not certain. Out of
    /// line, since most steps have a margin in all lanes.
    #[inline(never)]
    fn signs_by_coefficients(&self, margin: Lanes<L>, least: Lanes<L>) -> [f64; L] {
        let mut all = [Lanes([0.0; L]); 1 + 2 * LEADING_HALF_ORDER];
        self.copy_to(&mut all);
        bernstein::between(&mut all, 0.0, 1.0);
        core::array::from_fn(|lane| {
            let (sign, least) = (self.first.0[lane].signum(), least.0[lane]);
            let keeps =
                margin.0[lane] > 0.0 || all.iter().all(|value| value.0[lane] * sign > least);
            if keeps { sign } else { 0.0 }
        })
    }
}
