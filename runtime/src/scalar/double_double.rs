//! Double-double (double-word) arithmetic.
//!
//! A number is the unevaluated sum of two `f64`, the second of which is at most half a unit in the last place of the
//! first. Error-free sums and products: T. J. Dekker, *A floating-point technique for extending the available
//! precision*, Numer. Math. **18** (1971) 224–242. Operations: M. Joldes, J.-M. Muller & V. Popescu, *Tight and
//! rigorous error bounds for basic building blocks of double-word arithmetic*, ACM Trans. Math. Softw. **44** (2017)
//! 15. `runtime/scripts/double_double_constants.py` computes the constants.

mod constants;
mod decimal;
mod functions;
#[cfg(test)]
mod tests;

use core::ops::{Add, Div, Mul, Neg, Sub};

use super::arithmetic::arithmetic;

/// A number with about 32 decimal digits, with the exponent range of `f64`.
///
/// The relative error is about 10⁻³² for an operation and at most 10⁻³⁰ for an elementary function (for sine and cosine
/// up to arguments of 10⁶; beyond 10¹⁵ they have the precision of `f64`). The error of `powf` grows with the logarithm
/// of its result. Energies, accelerations and their derivatives are accurate to all digits if the parameters are. They
/// serve as reference values, and for differences that would be lost by rounding in `f64`.
///
/// The time of an integration and the coefficients of its method are `f64`. An integration on `DoubleDouble` has no
/// significant rounding errors of its own, but the rounded coefficients cause relative errors of about 10⁻¹⁶ times the
/// number of time scales, whatever the tolerance.
///
/// ```
/// use lagrangian::prelude::*;
/// use lagrangian::DoubleDouble;
///
/// #[derive(Lagrangian)]
/// #[lagrangian(
///     coordinates(theta),
///     kinetic = 0.5 * (l * dot(theta)).powi(2),
///     potential = -g * l * cos(theta),
/// )]
/// struct Pendulum<T: Scalar> { l: T, g: T }
///
/// let number = |digits: &str| digits.parse::<DoubleDouble>();
/// let pendulum = Pendulum { l: number("0.1")?, g: number("9.81")? };
/// let state = State::new(number("0")?, [number("0.3")?], [number("0")?]);
/// // −(g/l) sin θ
/// let expected = number("-28.99053227347741231783196515170119")?;
/// let error = pendulum.accelerations(&state)[0] - expected;
/// assert!(error.to_f64().abs() < 1e-29);
/// # Ok::<(), core::num::ParseFloatError>(())
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, PartialOrd)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct DoubleDouble {
    high: f64,
    low: f64,
}

/// Returns a + b and its rounding error (`TwoSum`).
#[inline]
fn two_sum(a: f64, b: f64) -> (f64, f64) {
    let sum = a + b;
    let b_rounded = sum - a;
    let a_rounded = sum - b_rounded;
    (sum, (a - a_rounded) + (b - b_rounded))
}

/// Returns a · b and its rounding error (`TwoProd`, by a fused multiply-add).
#[inline]
fn two_product(a: f64, b: f64) -> (f64, f64) {
    let product = a * b;
    #[cfg(feature = "std")]
    let error = f64::mul_add(a, b, -product);
    #[cfg(not(feature = "std"))]
    let error = libm::fma(a, b, -product);
    (product, error)
}

impl DoubleDouble {
    /// The number 0.
    pub(crate) const ZERO: Self = Self {
        high: 0.0,
        low: 0.0,
    };

    /// Returns the number nearest to the sum of two `f64`.
    #[inline]
    #[must_use]
    pub fn new(high: f64, low: f64) -> Self {
        let (high, low) = two_sum(high, low);
        Self::finite(high, low)
    }

    /// Returns the nearest `f64`.
    #[inline]
    #[must_use]
    pub fn to_f64(self) -> f64 {
        self.high
    }

    /// Returns the low part: the number minus [`to_f64`](Self::to_f64).
    #[inline]
    #[must_use]
    pub fn low(self) -> f64 {
        self.low
    }

    /// Creates a number from two parts, or from the first alone if it is infinite or NaN.
    #[inline]
    fn finite(high: f64, low: f64) -> Self {
        let low = if high.is_finite() { low } else { 0.0 };
        Self { high, low }
    }

    /// Returns the sum of two numbers, the first of which has the greater magnitude (`Fast2Sum`).
    #[inline]
    fn normalized(high: f64, low: f64) -> Self {
        let sum = high + low;
        Self::finite(sum, low - (sum - high))
    }

    #[inline]
    fn is_negative(self) -> bool {
        self.high < 0.0
    }

    #[inline]
    fn recip(self) -> Self {
        Self::from(1.0) / self
    }

    /// Returns the product with an `f64`: algorithm 9 of Joldes, Muller & Popescu.
    #[inline]
    fn times(self, factor: f64) -> Self {
        let (high, error) = two_product(self.high, factor);
        if !high.is_finite() {
            return Self::from(high);
        }
        Self::normalized(high, self.low * factor + error)
    }
}

impl From<f64> for DoubleDouble {
    #[inline]
    fn from(value: f64) -> Self {
        Self {
            high: value,
            low: 0.0,
        }
    }
}

impl Add for DoubleDouble {
    type Output = Self;

    /// Adds by algorithm 6 of Joldes, Muller & Popescu.
    #[inline]
    fn add(self, other: Self) -> Self {
        let (high, error) = two_sum(self.high, other.high);
        if !high.is_finite() {
            return Self::from(high);
        }
        let (low, rest) = two_sum(self.low, other.low);
        let sum = Self::normalized(high, error + low);
        Self::normalized(sum.high, sum.low + rest)
    }
}

impl Neg for DoubleDouble {
    type Output = Self;

    #[inline]
    fn neg(self) -> Self {
        Self {
            high: -self.high,
            low: -self.low,
        }
    }
}

impl Sub for DoubleDouble {
    type Output = Self;

    #[inline]
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for DoubleDouble {
    type Output = Self;

    /// Multiplies by algorithm 11 of Joldes, Muller & Popescu.
    #[inline]
    fn mul(self, other: Self) -> Self {
        let (high, error) = two_product(self.high, other.high);
        if !high.is_finite() {
            return Self::from(high);
        }
        let mixed = self.high * other.low + self.low * other.high;
        Self::normalized(high, error + mixed)
    }
}

impl Div for DoubleDouble {
    type Output = Self;

    /// Divides by long division with three quotient digits, each an `f64`.
    #[inline]
    fn div(self, other: Self) -> Self {
        let first = self.high / other.high;
        if !first.is_finite() || other.high.is_infinite() {
            return Self::from(first);
        }
        let rest = self - other.times(first);
        let second = rest.high / other.high;
        let rest = rest - other.times(second);
        let third = rest.high / other.high;
        Self::normalized(first, second) + Self::from(third)
    }
}

arithmetic! { [] DoubleDouble }
