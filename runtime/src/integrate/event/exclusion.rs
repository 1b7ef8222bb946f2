//! The exclusion of events from a step by enclosures of their polynomials.
//!
//! For 0 ≤ u ≤ 1, Σ aₖ uᵏ differs from a₀ by at most Σ |aₖ|, k ≥ 1, and lies between its least and its greatest
//! Bernstein coefficient (G. T. Cargo & O. Shisha, *The Bernstein form of a polynomial*, J. Res. Nat. Bur. Standards
//! **70B** (1966) 79–81). Most steps are far from any zero, and a few terms of the event functions and a sum are enough
//! for them. Terms of high order, which are sums of many products, are only computed if the low orders do not decide.

use super::declared_event::DeclaredEvents;
use super::event_dynamics::{EventDynamics, SingleNumber};
use crate::integrate::bernstein::{self, ROUNDINGS, as_number};
use crate::integrate::step_polynomial::StepPolynomial;
use crate::integrate::taylor::TaylorCoefficients;
use crate::limits::events::{
    LEADING_HALF_ORDER, MAX_COEFFICIENTS, MIN_REMAINING_PART, NEAR, UNCERTAINTY,
};
use crate::scalar::Scalar;

/// Determines the signs of event functions that have no zero in a step.
pub(super) struct Exclusion<'a, D: ?Sized, X, const K: usize> {
    pub(super) events: &'a DeclaredEvents<K>,
    pub(super) dynamics: &'a D,
    /// The state at the beginning of the step.
    pub(super) from: &'a X,
    /// The time of the end of the step.
    pub(super) end: f64,
    /// The event functions at the end of the step.
    pub(super) last: [f64; K],
    /// The event functions in the middle of the step. If they are given, all terms are computed; otherwise the first
    /// few, which then have to keep farther away from zero.
    pub(super) middle: Option<[f64; K]>,
}

impl<S, D, const K: usize> StepPolynomial<S, D::State> for Exclusion<'_, D, D::State, K>
where
    S: SingleNumber,
    D: EventDynamics<S> + ?Sized,
{
    /// The signs. `None` if one of the functions, or of the functions at whose zeros it has corners, may have a zero,
    /// or if a function differs from its polynomial.
    type Output = Option<[f64; K]>;

    fn visit<const HALF: usize>(
        self,
        t: f64,
        unit: f64,
        motion: &TaylorCoefficients<D::State, HALF>,
    ) -> Self::Output {
        let count = as_number(1 + 2 * HALF);
        if self.middle.is_some() {
            self.signs(t, unit, motion, count)
        } else if HALF > LEADING_HALF_ORDER {
            self.signs(t, unit, &motion.leading::<LEADING_HALF_ORDER>(), count)
        } else {
            None
        }
    }
}

impl<X, D: ?Sized, const K: usize> Exclusion<'_, D, X, K> {
    /// Returns the signs by the series of the functions along a motion, given the first terms of its series of `count`
    /// terms.
    fn signs<S, const HALF: usize>(
        &self,
        t: f64,
        unit: f64,
        motion: &TaylorCoefficients<X, HALF>,
        count: f64,
    ) -> Option<[f64; K]>
    where
        S: SingleNumber,
        D: EventDynamics<S, State = X>,
    {
        let numbers = [t, unit].map(S::from_f64);
        let series = (self.dynamics).event_series(numbers[0], self.from, numbers[1], motion)?;
        let length = (self.end - t) / unit;
        let kept = if self.middle.is_some() {
            0.0
        } else {
            MIN_REMAINING_PART
        };
        let mut signs = [0.0; K];
        for (event, (index, _)) in self.events.events.into_iter().enumerate() {
            let terms = Terms::<HALF>::of(&series, index, length)?;
            // If the last terms of a function vanish, a few terms tell nothing about the others.
            if self.middle.is_none() && terms.tail(count) <= terms.rounding(count) {
                return None;
            }
            signs[event] = terms.sign(count, kept)?;
            let is_near = |u: f64, values: &[f64; K]| {
                let value = values.get(event);
                value.is_some_and(|value| terms.is_near(u, *value, count))
            };
            let in_middle = self.middle.as_ref();
            if !is_near(1.0, &self.last) || !in_middle.is_none_or(|values| is_near(0.5, values)) {
                return None;
            }
            for branch in self.dynamics.branches(index) {
                Terms::<HALF>::of(&series, *branch, length)?.sign(count, kept)?;
            }
        }
        Some(signs)
    }
}

/// The terms of a function at the end of a step.
struct Terms<const HALF: usize> {
    first: f64,
    /// The terms of order 1 and higher.
    higher: [[f64; 2]; HALF],
    /// The sum of the magnitudes of the higher terms.
    sum: f64,
    epsilon: f64,
}

impl<const HALF: usize> Terms<HALF> {
    /// Returns the terms of a function at the end of the step; `None` if there is no such function.
    #[inline]
    fn of<S: Scalar, V: AsRef<[S]> + Clone>(
        series: &TaylorCoefficients<V, HALF>,
        index: usize,
        length: f64,
    ) -> Option<Self> {
        let number = |values: &V| values.as_ref().get(index).map(|value| value.smallest());
        let mut terms = Self {
            first: number(series.initial())?,
            higher: [[0.0; 2]; HALF],
            sum: 0.0,
            epsilon: S::machine_epsilon(),
        };
        let mut power = 1.0;
        let places = terms.higher.as_flattened_mut();
        for (place, values) in places.iter_mut().zip(series.higher()) {
            power *= length;
            *place = number(values)? * power;
            terms.sum += place.abs();
        }
        Some(terms)
    }

    /// Bounds the contribution of further terms, assuming `count` of them, as large as the last ones.
    fn tail(&self, count: f64) -> f64 {
        let last = self.higher.last().map_or([0.0; 2], |last| *last);
        count * last.map(f64::abs).into_iter().fold(0.0, f64::max)
    }

    /// Bounds the effect of rounding on the terms.
    fn rounding(&self, count: f64) -> f64 {
        let part = (UNCERTAINTY + ROUNDINGS * count) * self.epsilon.max(f64::EPSILON);
        part * (self.sum + self.first.abs())
    }

    /// Returns the sign in the whole step, if it is certain: if the distance of the enclosure from zero exceeds
    /// rounding errors, the contribution of further terms, and this part of the first term.
    fn sign(&self, count: f64, kept: f64) -> Option<f64> {
        let size = self.first.abs();
        let least = self.tail(count) + self.rounding(count) + kept * size;
        if size > self.sum + least {
            return Some(self.first.signum());
        }
        // The comparison is false for NaN.
        let is_beyond = |value: &f64| value * self.first.signum() > least;
        let mut all = [0.0; MAX_COEFFICIENTS];
        let all = all.get_mut(..=2 * HALF)?;
        let (first, higher) = all.split_first_mut()?;
        *first = self.first;
        higher.copy_from_slice(self.higher.as_flattened());
        bernstein::between(all, 0.0, 1.0);
        all.iter().all(is_beyond).then(|| self.first.signum())
    }

    /// Whether the polynomial at `u` agrees with `value`, up to further terms and a small part of the terms.
    fn is_near(&self, u: f64, value: f64, count: f64) -> bool {
        let terms = self.higher.as_flattened().iter().rev();
        let found = terms.fold(0.0, |sum, a| (sum + a) * u) + self.first;
        (found - value).abs() <= self.tail(count) + NEAR * (self.sum + self.first.abs())
    }
}
