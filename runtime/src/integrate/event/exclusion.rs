//! The exclusion of events from a step by enclosures of their polynomials.
//!
//! Σ aₖ uᵏ with 0 ≤ u ≤ 1 is within Σ |aₖ|, k ≥ 1, of a₀, and between the least and the greatest of its Bernstein coefficients
//! (G. T. Cargo & O. Shisha, *The Bernstein form of a polynomial*, J. Res. Nat. Bur. Standards **70B** (1966) 79–81). Most steps
//! are far from any zero, and need nothing more than the series of the event functions and a sum.

use super::bernstein::{self, ROUNDINGS, as_number};
use super::{DeclaredEvents, EventDynamics, SingleNumber};
use crate::integrate::step_polynomial::StepPolynomial;
use crate::integrate::taylor::TaylorCoefficients;
use crate::limits::events::{MOST_COEFFICIENTS, NEAR, UNCERTAINTY};
use crate::scalar::Scalar;

/// Tells the signs of event functions that have no zero in a step.
pub(super) struct Exclusion<'a, D: ?Sized, X, const K: usize> {
    pub(super) events: &'a DeclaredEvents<K>,
    pub(super) dynamics: &'a D,
    /// The state from which the step leads.
    pub(super) from: &'a X,
    /// When the step ends.
    pub(super) end: f64,
    /// The event functions in the middle and at the end of the step.
    pub(super) values: [[f64; K]; 2],
}

impl<S, D, const K: usize> StepPolynomial<S, D::State> for Exclusion<'_, D, D::State, K>
where
    S: SingleNumber,
    D: EventDynamics<S> + ?Sized,
{
    /// The signs; none if one of the functions, or of those at whose zeros it has corners, may have a zero, or differs from its
    /// polynomial.
    type Output = Option<[f64; K]>;

    fn visit<const HALF: usize>(
        self,
        t: f64,
        unit: f64,
        motion: &TaylorCoefficients<D::State, HALF>,
    ) -> Self::Output {
        let numbers = [t, unit].map(S::from_f64);
        let series = (self.dynamics).event_series(numbers[0], self.from, numbers[1], motion)?;
        let length = (self.end - t) / unit;
        let mut signs = [0.0; K];
        for (event, (index, _)) in self.events.events.into_iter().enumerate() {
            let terms = Terms::of(&series, index, length)?;
            let [middle, end] = self.values.map(|values| values.get(event).copied());
            signs[event] = terms.sign()?;
            if !terms.are_near(0.5, middle?) || !terms.are_near(1.0, end?) {
                return None;
            }
            for branch in self.dynamics.branches(index) {
                Terms::of(&series, *branch, length)?.sign()?;
            }
        }
        Some(signs)
    }
}

/// The terms of a function at the end of a step.
struct Terms {
    values: [f64; MOST_COEFFICIENTS],
    count: usize,
    /// The sum of the magnitudes of those of order 1 and more.
    sum: f64,
    epsilon: f64,
}

impl Terms {
    /// None where there are too many of them.
    #[inline]
    fn of<S: Scalar, V: AsRef<[S]> + Clone, const HALF: usize>(
        series: &TaylorCoefficients<V, HALF>,
        index: usize,
        length: f64,
    ) -> Option<Self> {
        let number = |values: &V| values.as_ref().get(index).map(|value| value.smallest());
        let mut terms = Self {
            values: [0.0; MOST_COEFFICIENTS],
            count: 1 + 2 * HALF,
            sum: 0.0,
            epsilon: S::machine_epsilon(),
        };
        let places = terms.values.get_mut(..terms.count)?;
        let (first, higher) = places.split_first_mut()?;
        *first = number(series.initial())?;
        let mut power = 1.0;
        for (place, values) in higher.iter_mut().zip(series.higher()) {
            power *= length;
            *place = number(values)? * power;
            terms.sum += place.abs();
        }
        Some(terms)
    }

    fn terms(&self) -> &[f64] {
        self.values.get(..self.count).unwrap_or_default()
    }

    /// The sign in the whole step, if it is certain: the enclosure keeps away from zero by rounding errors and by what as many
    /// further terms might add if they were as large as the last ones.
    fn sign(&self) -> Option<f64> {
        let first = *self.terms().first()?;
        let last = self.terms().iter().rev().take(2);
        let last = last.fold(0.0, |last: f64, term| last.max(term.abs()));
        let count = as_number(self.count);
        let rounding = (UNCERTAINTY + ROUNDINGS * count) * self.epsilon.max(f64::EPSILON);
        let least = count * last + rounding * (self.sum + first.abs());
        if first.abs() > self.sum + least {
            return Some(first.signum());
        }
        // Not a number is no sign.
        let is_beyond = |value: &f64| value * first.signum() > least;
        let mut all = self.values;
        let all = all.get_mut(..self.count)?;
        bernstein::between(all, 0.0, 1.0);
        all.iter().all(is_beyond).then(|| first.signum())
    }

    /// Whether the value at `u` is this one, but for a small part of the terms.
    fn are_near(&self, u: f64, value: f64) -> bool {
        let found = self.terms().iter().rev().fold(0.0, |sum, a| sum * u + a);
        let first = self.terms().first().copied().unwrap_or(0.0);
        (found - value).abs() <= NEAR * (self.sum + first.abs())
    }
}
