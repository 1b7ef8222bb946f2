//! Differences that should vanish.

use crate::limits::{MAX_WITHIN_RANGE, NEGLIGIBLE_DIFFERENCE};
use crate::validation::method::Method;
use crate::validation::sum_with_size::SumWithSize;

/// A difference that should vanish.
pub(crate) struct Comparison {
    pub(crate) method: Method,
    pub(crate) difference: f64,
    /// What was added up to it.
    size: f64,
}

impl Comparison {
    /// Whether the difference is finite and more than negligible.
    pub(crate) fn is_significant(&self) -> bool {
        self.difference.is_finite() && self.difference.abs() > NEGLIGIBLE_DIFFERENCE * self.size
    }
}

/// All differences at one point.
#[derive(Default)]
pub(crate) struct Comparisons(pub(crate) Vec<Comparison>);

impl Comparisons {
    fn push(&mut self, method: Method, difference: f64, size: f64) {
        self.0.push(Comparison {
            method,
            difference,
            size,
        });
    }

    /// Values that should be equal, where they exist.
    pub(crate) fn values(&mut self, method: Method, found: &[f64], expected: &[f64]) {
        for (found, expected) in found.iter().zip(expected) {
            if expected.is_finite() {
                self.push(method, found - expected, found.abs() + expected.abs());
            }
        }
    }

    /// Solutions of a system of equations that should be equal: their errors are in proportion to the greatest of them.
    pub(crate) fn solutions(&mut self, method: Method, found: &[f64], expected: &[f64]) {
        let greatest = expected.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
        for (found, expected) in found.iter().zip(expected) {
            if expected.is_finite() {
                self.push(method, found - expected, found.abs() + greatest);
            }
        }
    }

    /// Values that should be equal to sums, where these exist.
    pub(crate) fn balances(&mut self, method: Method, found: &[f64], expected: &[SumWithSize]) {
        for (found, expected) in found.iter().zip(expected) {
            if expected.size.is_finite() {
                self.push(method, found - expected.total, found.abs() + expected.size);
            }
        }
    }

    /// Sums that should be equal to values.
    pub(crate) fn against(&mut self, method: Method, found: &[SumWithSize], expected: &[f64]) {
        for (found, expected) in found.iter().zip(expected) {
            self.push(method, found.total - expected, found.size + expected.abs());
        }
    }

    /// Sums that should vanish.
    pub(crate) fn vanishing(&mut self, method: Method, balances: &[SumWithSize]) {
        for balance in balances {
            self.push(method, balance.total, balance.size);
        }
    }

    /// Leaves out what has no value, where an intermediate result of this magnitude explains it.
    pub(crate) fn forgive_overflow(&mut self, largest: f64) {
        if largest.is_nan() || largest > MAX_WITHIN_RANGE {
            self.0
                .retain(|comparison| comparison.difference.is_finite());
        }
    }

    /// What has no value here.
    pub(crate) fn undefined(&mut self, method: Method) {
        self.push(method, f64::NAN, f64::NAN);
    }
}
