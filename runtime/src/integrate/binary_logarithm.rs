//! The binary logarithm and its inverse to six digits, for the choice of step sizes: a call to the exact library
//! functions takes as long as several orders of a series.

use core::f64::consts::{LN_2, LOG2_E, SQRT_2};

use crate::scalar::Scalar;

/// The bits of 1.
const ONE: u64 = 1.0_f64.to_bits();

/// The bits of 2⁵², in whose binade the last bits of a number are an integer.
const INTEGERS: u64 = 4_503_599_627_370_496.0_f64.to_bits();

/// 1.5 · 2⁵²: a number added to it loses its fraction.
const SHIFT: f64 = 6_755_399_441_055_744.0;

/// Below this magnitude of x, 2ˣ neither overflows nor underflows.
const MAX_EXPONENT: f64 = 1000.0;

/// The exponent bits of a number.
pub(super) const EXPONENT: u64 = 0x7ff0_0000_0000_0000;

/// Returns the binary logarithm of a positive number to seven digits, by ln z = 2 artanh((z − 1)/(z + 1)) (Abramowitz &
/// Stegun, *Handbook of Mathematical Functions*, 1964, 4.1.27) about the middle of a binade.
#[inline]
pub(super) fn log2(x: f64) -> f64 {
    if x.is_normal() {
        log2_of_normal(x)
    } else {
        Scalar::ln(x) * LOG2_E
    }
}

/// [`log2`] in each lane.
#[inline]
pub(super) fn log2_of_each<const L: usize>(x: [f64; L]) -> [f64; L] {
    if are_normal(&x) {
        x.map(log2_of_normal)
    } else {
        x.map(log2)
    }
}

/// Whether all numbers are positive and normal.
#[inline]
pub(super) fn are_normal<const L: usize>(x: &[f64; L]) -> bool {
    x.iter().fold(true, |all, x| all & is_normal(*x))
}

/// Whether a number is positive and normal. This is a single comparison without a branch, which the compiler makes in all
/// lanes at once.
#[inline]
pub(super) fn is_normal(x: f64) -> bool {
    const LEAST: u64 = f64::MIN_POSITIVE.to_bits();
    x.to_bits().wrapping_sub(LEAST) <= f64::MAX.to_bits() - LEAST
}

#[inline]
fn log2_of_normal(x: f64) -> f64 {
    let bits = x.to_bits();
    let mantissa = f64::from_bits((bits & !EXPONENT) | ONE);
    // The exponents are the last bits of these two numbers, so that their difference is exact.
    let exponent = f64::from_bits(INTEGERS | (bits >> 52)) - f64::from_bits(INTEGERS | (ONE >> 52));
    let z = (mantissa - SQRT_2) / (mantissa + SQRT_2);
    let square = z * z;
    exponent
        + 0.5
        + 2.0
            * LOG2_E
            * z
            * (1.0 + square * (1.0 / 3.0 + square * (1.0 / 5.0 + square * (1.0 / 7.0))))
}

/// Returns 2ˣ to six digits, by the series of the exponential function about the nearest integer.
#[inline]
pub(super) fn exp2(x: f64) -> f64 {
    if x.abs() < MAX_EXPONENT {
        exp2_of_moderate(x)
    } else {
        Scalar::exp(x * LN_2)
    }
}

/// [`exp2`] in each lane.
#[inline]
pub(super) fn exp2_of_each<const L: usize>(x: [f64; L]) -> [f64; L] {
    if x.iter().fold(true, |all, x| all & (x.abs() < MAX_EXPONENT)) {
        x.map(exp2_of_moderate)
    } else {
        x.map(exp2)
    }
}

#[inline]
fn exp2_of_moderate(x: f64) -> f64 {
    // The sum has no bits for a fraction, so that its last bits are the nearest integer.
    let shifted = x + SHIFT;
    let z = (x - (shifted - SHIFT)) * LN_2;
    let power = f64::from_bits(shifted.to_bits() << 52)
        .to_bits()
        .wrapping_add(ONE);
    let series = 1.0 / 6.0 + z * (1.0 / 24.0 + z * (1.0 / 120.0 + z * (1.0 / 720.0)));
    f64::from_bits(power) * (1.0 + z * (1.0 + z * (0.5 + z * series)))
}

#[cfg(test)]
mod tests {
    use super::{exp2, exp2_of_each, log2, log2_of_each};

    /// Numbers of all sizes.
    fn numbers() -> impl Iterator<Item = f64> {
        (-1070..1020).map(|i| (1.0 + f64::from(i).sin().abs()) * libm::ldexp(1.0, i))
    }

    #[test]
    fn powers_and_logarithms_have_six_digits() {
        for x in numbers() {
            let exact = libm::log2(x);
            assert!((log2(x) - exact).abs() < 2e-7, "{x:e}");
            if exact > -1020.0 {
                assert!((exp2(exact) / x - 1.0).abs() < 2e-7, "{x:e}");
            }
        }
        for fraction in [0.499_999, 0.5, 0.500_001, -0.5] {
            assert!((exp2(3.0 + fraction) / libm::exp2(3.0 + fraction) - 1.0).abs() < 2e-7);
        }
        assert!(log2(f64::INFINITY) >= f64::INFINITY && exp2(f64::INFINITY) >= f64::INFINITY);
        assert!(log2(f64::NAN).is_nan() && exp2(f64::NAN).is_nan());
        assert!(exp2(-2000.0).abs() <= 0.0);
    }

    #[test]
    fn of_each_lane_they_are_those_of_its_number() {
        for numbers in [
            [0.3, 7.5, 1e-200, 1e200],
            [0.0, 2.0, f64::NAN, f64::INFINITY],
            [5e-324, 1.0, -1.0, 3.0],
        ] {
            let bits =
                |numbers: [f64; 4]| numbers.map(|x| if x.is_nan() { 0 } else { x.to_bits() });
            assert_eq!(bits(log2_of_each(numbers)), bits(numbers.map(log2)));
            assert_eq!(bits(exp2_of_each(numbers)), bits(numbers.map(exp2)));
        }
    }
}
