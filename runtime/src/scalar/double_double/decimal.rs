//! Conversion from and to decimal numbers.

use core::fmt;
use core::num::ParseFloatError;
use core::str::FromStr;

use num_traits::{One as _, Zero as _};

use super::DoubleDouble;
use super::constants::{MAX_POWER_OF_TEN, READ_DIGITS};
use crate::scalar::Scalar;

impl DoubleDouble {
    /// Returns 10ⁿ.
    fn power_of_ten(n: u32) -> Self {
        (0..n).fold(Self::one(), |power, _| power.times(10.0))
    }

    /// Returns self · 10ⁿ.
    fn times_power_of_ten(mut self, n: i32) -> Self {
        let mut left = n;
        while left != 0 && !self.is_zero() && self.is_finite() {
            let part = left.clamp(-MAX_POWER_OF_TEN, MAX_POWER_OF_TEN);
            let power = Self::power_of_ten(part.unsigned_abs());
            self = if part < 0 { self / power } else { self * power };
            left -= part;
        }
        self
    }
}

/// Parses the syntax of `f64`, and keeps all digits.
///
/// ```
/// use lagrangian::{DoubleDouble, Scalar};
///
/// let tenth: DoubleDouble = "0.1".parse()?;
/// assert_eq!(tenth, DoubleDouble::ratio(1.0, 10.0));
/// # Ok::<(), core::num::ParseFloatError>(())
/// ```
impl FromStr for DoubleDouble {
    type Err = ParseFloatError;

    fn from_str(written: &str) -> Result<Self, ParseFloatError> {
        // From here on the syntax is valid.
        let nearest: f64 = written.parse()?;
        if !nearest.is_finite() {
            return Ok(Self::from(nearest));
        }
        let (mantissa, exponent) = written.split_once(['e', 'E']).unwrap_or((written, "0"));
        // An exponent that overflows belongs to a zero, since the number is finite.
        let mut exponent: i32 = exponent.parse().unwrap_or(0);
        let (mut number, mut digits, mut behind_the_point) = (Self::zero(), 0, false);
        for character in mantissa.chars() {
            let Some(digit) = character.to_digit(10) else {
                behind_the_point |= character == '.';
                continue;
            };
            if digits < READ_DIGITS {
                number = number.times(10.0) + Self::from(f64::from(digit));
                digits += u32::from(!number.is_zero());
                exponent -= i32::from(behind_the_point);
            } else {
                exponent += i32::from(!behind_the_point);
            }
        }
        let number = number.times_power_of_ten(exponent);
        let negative = mantissa.starts_with('-');
        Ok(if negative { -number } else { number })
    }
}

/// Writes a digit, a point, as many digits as the precision says, and a power of ten. The precision is 31 by default
/// and at most.
impl fmt::LowerExp for DoubleDouble {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let precision = f.precision().unwrap_or(31).min(31);
        if !self.is_finite() || self.is_zero() {
            return write!(f, "{:.precision$e}", self.high);
        }
        #[allow(clippy::cast_possible_truncation)] // An integer between −324 and 308.
        let mut exponent = libm::floor(libm::log10(self.high.abs())) as i32;
        let ten = Self::from(10.0);
        let mut rest = self.abs().times_power_of_ten(-exponent);
        // The logarithm of a number near a power of ten may be rounded to the wrong side.
        while rest < Self::one() {
            (rest, exponent) = (rest.times(10.0), exponent - 1);
        }
        rest += Self::from(0.5).times_power_of_ten(-i32::try_from(precision).unwrap_or(31));
        while rest >= ten {
            (rest, exponent) = (rest / ten, exponent + 1);
        }
        f.write_str(if self.is_negative() { "-" } else { "" })?;
        for place in 0..=precision {
            let mut digit = libm::floor(rest.high);
            if rest < Self::from(digit) {
                digit -= 1.0;
            }
            let point = if place == 0 && precision > 0 { "." } else { "" };
            write!(f, "{digit:.0}{point}")?;
            rest = (rest - Self::from(digit)).times(10.0);
        }
        write!(f, "e{exponent}")
    }
}

/// Formats like `{:e}`.
impl fmt::Display for DoubleDouble {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::LowerExp::fmt(self, f)
    }
}
