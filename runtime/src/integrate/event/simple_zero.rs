//! A zero of a polynomial in an interval in which it is the only one.

use super::terms::Terms;
use crate::limits::events::{
    LAST_NEWTON_STEP, MAX_NEWTON_STEPS, MAX_ZERO_WIDTH, ROUNDINGS_AT_ZERO,
};

/// A simple zero, on both sides of which the signs are certain.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct SimpleZero {
    /// Its position as a fraction of the step.
    pub(super) at: f64,
    /// The magnitude of the slope there.
    pub(super) slope: f64,
    /// How far from the zero the signs on both sides of it are certain, as a fraction of the step.
    width: f64,
    /// The effect of rounding on the function.
    noise: f64,
}

impl SimpleZero {
    /// Returns the only zero of a function with these terms between two fractions of a step; `None` if rounding or further terms
    /// leave its position in doubt.
    pub(super) fn of<const HALF: usize>(terms: &Terms<f64, HALF>, ends: [f64; 2]) -> Option<Self> {
        let (at, slope) = newton(terms, ends);
        let width = 2.0 * terms.least(0.0) / slope.abs();
        // The comparison is false for NaN.
        (width <= MAX_ZERO_WIDTH).then(|| Self {
            at,
            slope: slope.abs(),
            width,
            noise: 0.0,
        })
    }

    /// Returns the zero of a function whose values have rounding errors of this size.
    pub(super) fn with_noise(self, noise: f64) -> Self {
        let width = self.width + 2.0 * noise / self.slope;
        Self {
            width,
            noise,
            ..self
        }
    }

    /// Returns the fraction up to which the sign before the zero is certain.
    pub(super) fn from(&self) -> f64 {
        self.at - self.width
    }

    /// Returns the fraction from which on the sign behind the zero is certain, at most the end of the step.
    pub(super) fn until(&self) -> f64 {
        (self.at + self.width).min(1.0)
    }

    /// Whether a value of the function near the zero is a rounding error: of the value, of a fraction of the step, or of a time,
    /// which is given in steps.
    pub(super) fn is_rounding_error(&self, value: f64, time: f64) -> bool {
        let rounding = f64::EPSILON * (1.0 + time.abs());
        value.abs() <= ROUNDINGS_AT_ZERO * (self.noise + rounding * self.slope)
    }
}

/// Returns the zero by Newton's method, kept between ends with different signs by bisection (W. H. Press et al., *Numerical
/// Recipes*, 3rd edition 2007, section 9.4), and the slope next to it. The error is about the square of the last step.
fn newton<const HALF: usize>(
    terms: &Terms<f64, HALF>,
    [mut low, mut high]: [f64; 2],
) -> (f64, f64) {
    let [first, last] = [low, high].map(|end| terms.value(end));
    let mut slope = (last - first) / (high - low);
    let mut u = low - first / slope;
    for _ in 0..MAX_NEWTON_STEPS {
        let value;
        [value, slope] = terms.value_and_slope(u);
        if value * first > 0.0 {
            low = u;
        } else {
            high = u;
        }
        let next = u - value / slope;
        let next = if next >= low && next <= high {
            next
        } else {
            0.5 * (low + high)
        };
        let moved = (next - u).abs();
        u = next;
        if moved <= LAST_NEWTON_STEP {
            break;
        }
    }
    (u, slope)
}

#[cfg(test)]
mod tests {
    use super::SimpleZero;
    use crate::integrate::event::terms::Terms;
    use crate::integrate::taylor::TaylorCoefficients;

    /// The zero of a polynomial of order 4, of which all further terms vanish.
    fn zero(coefficients: [f64; 5], length: f64) -> Option<SimpleZero> {
        let mut series = TaylorCoefficients::<f64, 3>::new(0.0);
        *series.initial_mut() = coefficients[0];
        series.higher_mut()[..4].copy_from_slice(&coefficients[1..]);
        let terms = Terms::new(&series, length, (f64::EPSILON, 7.0));
        let step = [0.0, 1.0];
        (terms.sign_changes(step, 0.0) == Some(1)).then(|| SimpleZero::of(&terms, step))?
    }

    #[test]
    fn a_single_zero_is_found_to_the_last_bit() {
        for root in [0.1, 0.3, 1.0 / 3.0, 0.5, 0.77, 0.95] {
            // (x − 2 root) (x² + 1), over a step of 2.
            let shift = 2.0 * root;
            let found = zero([-shift, 1.0, -shift, 1.0, 0.0], 2.0).map(|zero| zero.at);
            let distance = found.map(|found| (found - root).abs());
            assert!(distance <= Some(2.0 * f64::EPSILON), "{root} {found:?}");
        }
    }

    #[test]
    fn other_polynomials_are_left_to_the_search() {
        // Two zeros, none, a double one, three, and one at the beginning.
        assert_eq!(zero([0.24, -1.4, 2.0, 0.0, 0.0], 1.0), None);
        assert_eq!(zero([1.0, 0.5, 0.0, 0.0, 0.0], 1.0), None);
        assert_eq!(zero([0.25, -1.0, 1.0, 0.0, 0.0], 1.0), None);
        assert_eq!(zero([-0.09375, 0.6875, -1.5, 1.0, 0.0], 1.0), None);
        assert_eq!(zero([0.0, 1.0, 0.0, 0.0, 0.0], 1.0), None);
    }

    #[test]
    fn values_beyond_rounding_errors_are_no_zeros() {
        let zero = zero([-0.3, 1.0, 0.0, 0.0, 0.0], 1.0);
        let zero = zero.map(|zero| zero.with_noise(1e-15));
        let is_rounding_error = |value, time| zero.map(|zero| zero.is_rounding_error(value, time));
        assert_eq!(is_rounding_error(1e-14, 0.0), Some(true));
        assert_eq!(is_rounding_error(1e-13, 0.0), Some(false));
        // A hundred steps after the time 0, times are rounded to a hundredth of the digits of a step.
        assert_eq!(is_rounding_error(1e-13, 100.0), Some(true));
        assert_eq!(is_rounding_error(1e-11, 100.0), Some(false));
    }
}
