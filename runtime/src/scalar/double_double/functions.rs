//! The elementary functions: Taylor series of a reduced argument (three-part reduction by W. J. Cody & W. Waite,
//! *Software Manual for the Elementary Functions*, 1980), or one step of Newton's method from the value in `f64`, which
//! doubles the number of correct digits.

use num_traits::{One as _, Zero as _};

use super::constants::{
    ASINH_IS_LN, EXP_OVERFLOWS, EXP_RANGE, HALF_PI, INVERSE_FACTORIALS, LN_2, LN_RANGE, NEAR_ONE,
    PI, REDUCIBLE, TANH_SATURATES,
};
use super::{DoubleDouble, two_product};
use crate::scalar::Scalar;

/// Returns ln 2.
fn ln_2() -> DoubleDouble {
    DoubleDouble::finite(LN_2[0], LN_2[1])
}

impl DoubleDouble {
    /// Returns self · 2ⁿ, which is exact.
    fn times_power_of_two(self, n: i32) -> Self {
        Self::finite(libm::ldexp(self.high, n), libm::ldexp(self.low, n))
    }

    /// Returns Σ sᵏ xⁱ/i! over i = 2k + `first`, where `first` is 0 or 1, s is the `sign` and |x| ≤ 1.
    fn series(self, first: usize, sign: f64) -> Self {
        let square = self * self * Self::from(sign);
        let coefficients = INVERSE_FACTORIALS.iter().skip(first).step_by(2).rev();
        let sum = coefficients.fold(Self::zero(), |sum, &(high, low)| {
            sum * square + Self { high, low }
        });
        if first == 0 { sum } else { sum * self }
    }

    /// Returns the integer k and the remainder in x = k · step + remainder, where |remainder| is at most about half a
    /// step. The step is given in three parts; the first difference is exact.
    fn reduced(self, step: [f64; 3]) -> (f64, Self) {
        let [first, second, third] = step;
        let k = libm::round(self.high / first);
        let product = |part: f64| {
            let (high, low) = two_product(k, part);
            Self::finite(high, low)
        };
        let rest = self - product(first) - product(second);
        (k, rest - Self::from(k * third))
    }

    /// Performs one step of Newton's method for function(y) = self, from a value with the precision of `f64`.
    fn refined(
        self,
        from: f64,
        function: impl Fn(Self) -> Self,
        slope: impl Fn(Self) -> Self,
    ) -> Self {
        let y = Self::from(from);
        let slope = slope(y);
        if slope.is_zero() || !from.is_finite() {
            return y;
        }
        y + (self - function(y)) / slope
    }

    /// Returns sine and cosine with the precision of `f64`, from the values for both parts and the addition theorems.
    fn rounded_sin_cos(self) -> (Self, Self) {
        let [high, low] = [self.high, self.low].map(|part| (libm::sin(part), libm::cos(part)));
        let sine = high.0 * low.1 + high.1 * low.0;
        let cosine = high.1 * low.1 - high.0 * low.0;
        (Self::from(sine), Self::from(cosine))
    }

    /// Returns √(1 − x²).
    fn complement(self) -> Self {
        ((Self::one() - self) * (Self::one() + self)).sqrt()
    }

    fn is_integer(self) -> bool {
        libm::trunc(self.high).to_bits() == self.high.to_bits()
            && libm::trunc(self.low).to_bits() == self.low.to_bits()
    }

    /// Returns whether an integer is odd.
    fn is_odd(self) -> bool {
        let odd = |part: f64| libm::fabs(libm::fmod(part, 2.0)) > 0.5;
        odd(self.high) != odd(self.low)
    }
}

impl Scalar for DoubleDouble {
    #[inline]
    fn from_f64(value: f64) -> Self {
        Self::from(value)
    }

    #[inline]
    fn ratio(numerator: f64, denominator: f64) -> Self {
        Self::from(numerator) / Self::from(denominator)
    }

    #[inline]
    fn pi() -> Self {
        PI
    }

    /// 2⁻⁹¹⁶: below it the low part has no digits.
    #[inline]
    fn min_positive() -> Self {
        Self::from(f64::MIN_POSITIVE / (f64::EPSILON * f64::EPSILON) * 4.0)
    }

    #[inline]
    fn smallest(self) -> f64 {
        self.high
    }

    #[inline]
    fn largest(self) -> f64 {
        self.high
    }

    #[inline]
    fn machine_epsilon() -> f64 {
        f64::EPSILON * f64::EPSILON
    }

    fn sin_cos(self) -> (Self, Self) {
        if self.high.abs() > REDUCIBLE {
            return self.rounded_sin_cos();
        }
        let (quarters, rest) = self.reduced(HALF_PI);
        let (sine, cosine) = (rest.series(1, -1.0), rest.series(0, -1.0));
        let quadrant = quarters - 4.0 * libm::floor(quarters / 4.0);
        if quadrant < 0.5 {
            (sine, cosine)
        } else if quadrant < 1.5 {
            (cosine, -sine)
        } else if quadrant < 2.5 {
            (-sine, -cosine)
        } else {
            (-cosine, sine)
        }
    }

    fn sin(self) -> Self {
        self.sin_cos().0
    }

    fn cos(self) -> Self {
        self.sin_cos().1
    }

    fn tan(self) -> Self {
        let (sine, cosine) = self.sin_cos();
        sine / cosine
    }

    fn asin(self) -> Self {
        self.atan2(self.complement())
    }

    fn acos(self) -> Self {
        self.complement().atan2(self)
    }

    fn atan(self) -> Self {
        self.atan2(Self::one())
    }

    /// Adds the tangent of the remaining angle to the angle in `f64`; the tangent equals the remaining angle up to a
    /// cube.
    fn atan2(self, x: Self) -> Self {
        let angle = Self::from(Scalar::atan2(self.high, x.high));
        if (self.is_zero() && x.is_zero()) || !self.is_finite() || !x.is_finite() {
            return angle;
        }
        let (sine, cosine) = angle.sin_cos();
        let scale = self.common_scale(x);
        let (self_, x) = (self * scale, x * scale);
        angle + (self_ * cosine - x * sine) / (x * cosine + self_ * sine)
    }

    #[inline]
    fn common_scale(self, other: Self) -> Self {
        Self::from(self.high.common_scale(other.high))
    }

    fn sinh(self) -> Self {
        if self.high.abs() < 1.0 {
            return self.series(1, 1.0);
        }
        let growing = self.exp();
        (growing - growing.recip()).times_power_of_two(-1)
    }

    fn cosh(self) -> Self {
        let growing = self.exp();
        (growing + growing.recip()).times_power_of_two(-1)
    }

    fn tanh(self) -> Self {
        if self.high.abs() > TANH_SATURATES {
            return self.signum();
        }
        self.sinh() / self.cosh()
    }

    fn asinh(self) -> Self {
        if self.high.abs() > ASINH_IS_LN && self.is_finite() {
            // √(x² + 1) is |x| to all digits: ln 2|x|.
            return (self.abs().ln() + ln_2()) * self.signum();
        }
        self.refined(Scalar::asinh(self.high), Self::sinh, Self::cosh)
    }

    /// Computes 2 arsinh √((x − 1)/2), without cancellation near 1.
    fn acosh(self) -> Self {
        let root = (self - Self::one()).times_power_of_two(-1).sqrt();
        root.asinh().times_power_of_two(1)
    }

    fn atanh(self) -> Self {
        let slope = |y: Self| (y.cosh() * y.cosh()).recip();
        self.refined(Scalar::atanh(self.high), Self::tanh, slope)
    }

    fn exp(self) -> Self {
        if !self.is_finite() || self.high < -EXP_RANGE || self.high > EXP_OVERFLOWS {
            // Infinite, or so small that the lower part has no digits.
            return Self::from(Scalar::exp(self.high));
        }
        if self.high > EXP_RANGE {
            // The largest power of two is too large to multiply by.
            let root = self.times_power_of_two(-1).exp();
            return root * root;
        }
        let (twos, rest) = self.reduced(LN_2);
        #[allow(clippy::cast_possible_truncation)] // An integer between −1011 and 1011.
        let twos = twos as i32;
        (rest.series(1, 1.0) + rest.series(0, 1.0)).times_power_of_two(twos)
    }

    /// Computes 2 artanh((x − 1)/(x + 1)) near 1, without cancellation.
    fn ln(self) -> Self {
        let from_one = self - Self::one();
        if from_one.high.abs() < NEAR_ONE {
            let quotient = from_one / (self + Self::one());
            return quotient.atanh().times_power_of_two(1);
        }
        if self.high > LN_RANGE && self.is_finite() {
            // The exponential of the rounded logarithm might be infinite.
            return self.times_power_of_two(-100).ln() + Self::from(100.0) * ln_2();
        }
        self.refined(Scalar::ln(self.high), Self::exp, Self::exp)
    }

    fn sech(self) -> Self {
        let small = (-self.abs()).exp();
        (small + small) / (Self::one() + small * small)
    }

    fn logistic(self) -> Self {
        // The argument is not positive, so that the exponential does not overflow.
        let small = (-self.abs()).exp();
        let part = if self.is_negative() {
            small
        } else {
            Self::one()
        };
        part / (Self::one() + small)
    }

    fn sqrt(self) -> Self {
        let slope = |y: Self| y.times_power_of_two(1);
        self.refined(Scalar::sqrt(self.high), |y| y * y, slope)
    }

    fn powf(self, exponent: Self) -> Self {
        let power = || (self.abs().ln() * exponent).exp();
        if self.is_zero() || !self.is_finite() || !exponent.is_finite() {
            Self::from(Scalar::powf(self.high, exponent.high))
        } else if !self.is_negative() {
            power()
        } else if !exponent.is_integer() {
            Self::from(f64::NAN)
        } else if exponent.is_odd() {
            -power()
        } else {
            power()
        }
    }

    #[inline]
    fn abs(self) -> Self {
        if self.is_negative() { -self } else { self }
    }

    #[inline]
    fn signum(self) -> Self {
        Self::from(Scalar::signum(self.high))
    }

    #[inline]
    fn min(self, other: Self) -> Self {
        if other < self { other } else { self }
    }

    #[inline]
    fn max(self, other: Self) -> Self {
        if other > self { other } else { self }
    }
}
