//! Numbers of twice the digits of `f64` as a scalar of derived models.
//!
//! A number is the sum of two of `f64`, the second of which is at most half a unit in the last place of
//! the first. Sums and products without error: Dekker, *Numer. Math.* **18** (1971) 224; the algorithms
//! for two of them: Joldes, Muller & Popescu, *ACM Trans. Math. Softw.* **44** (2017) 15. Elementary
//! functions are Taylor series of a reduced argument, or one step of Newton's method from the function
//! of `f64`, which doubles its digits.

#[cfg(test)]
mod tests;

use std::ops::{Add, Div, Mul, Neg, Sub};

use lagrangian::Scalar;
use num_traits::{One, Zero};

use crate::arithmetic::arithmetic;

/// A number of about 32 decimal digits.
#[derive(Clone, Copy, Debug, PartialEq, PartialOrd)]
pub struct DoubleDouble {
    high: f64,
    low: f64,
}

const PI: DoubleDouble = DoubleDouble {
    high: std::f64::consts::PI,
    low: 1.224_646_799_147_353_2e-16,
};

const LN_2: DoubleDouble = DoubleDouble {
    high: std::f64::consts::LN_2,
    low: 2.319_046_813_846_299_6e-17,
};

/// a + b and its rounding error.
fn two_sum(a: f64, b: f64) -> (f64, f64) {
    let sum = a + b;
    let b_rounded = sum - a;
    let a_rounded = sum - b_rounded;
    (sum, (a - a_rounded) + (b - b_rounded))
}

/// a · b and its rounding error.
fn two_product(a: f64, b: f64) -> (f64, f64) {
    let product = a * b;
    (product, f64::mul_add(a, b, -product))
}

impl DoubleDouble {
    /// The sum of two numbers, of which the first is the greater.
    fn normalized(high: f64, low: f64) -> Self {
        let sum = high + low;
        Self {
            high: sum,
            low: low - (sum - high),
        }
    }

    /// The number that decimal digits write, such as `-1.25`.
    ///
    /// # Panics
    ///
    /// If there is something else than digits, one point and a sign before them.
    #[must_use]
    pub fn parse(written: &str) -> Self {
        let digits = written.trim_start_matches('-');
        let ten = Self::from_f64(10.0);
        let mut number = Self::zero();
        for digit in digits.chars().filter(|digit| *digit != '.') {
            let digit = digit.to_digit(10).expect("a decimal digit");
            number = number * ten + Self::from_f64(digit.into());
        }
        let fraction = digits.split('.').nth(1).unwrap_or_default();
        for _ in fraction.chars() {
            number /= ten;
        }
        if digits == written { number } else { -number }
    }

    /// The nearest number of `f64`.
    #[must_use]
    pub fn to_f64(self) -> f64 {
        self.high
    }

    fn is_negative(self) -> bool {
        self.high < 0.0
    }

    /// self · 2ⁿ, which is exact.
    fn times_power_of_two(self, n: f64) -> Self {
        // In two halves, neither of which overflows where the result does not.
        let half = (n / 2.0).trunc();
        let scale = |x: f64| x * half.exp2() * (n - half).exp2();
        Self {
            high: scale(self.high),
            low: scale(self.low),
        }
    }

    /// Σ xⁱ/i! over every other i from `first` on, which is 0 or 1, with alternating signs if the
    /// `sign` is −1.
    fn series(self, first: u8, sign: f64) -> Self {
        let square = self * self * Self::from_f64(sign);
        let mut term = if first == 0 { Self::one() } else { self };
        let mut sum = term;
        let mut i = f64::from(first);
        while term.high.abs() > 1e-34 * sum.high.abs() {
            term = term * square / Self::from_f64((i + 1.0) * (i + 2.0));
            sum += term;
            i += 2.0;
        }
        sum
    }

    /// Both sides of x = k · step + rest, |rest| at most half a step.
    fn reduced(self, step: Self) -> (f64, Self) {
        let k = (self / step).high.round();
        (k, self - step * Self::from_f64(k))
    }

    /// One step of Newton's method for function(y) = self, from a value with the digits of `f64`.
    fn refined(
        self,
        from: f64,
        function: impl Fn(Self) -> Self,
        slope: impl Fn(Self) -> Self,
    ) -> Self {
        let y = Self::from_f64(from);
        let slope = slope(y);
        if slope.is_zero() || !from.is_finite() {
            return y;
        }
        y + (self - function(y)) / slope
    }
}

impl Add for DoubleDouble {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        let (high, error) = two_sum(self.high, other.high);
        let (low, rest) = two_sum(self.low, other.low);
        let sum = Self::normalized(high, error + low);
        Self::normalized(sum.high, sum.low + rest)
    }
}

impl Neg for DoubleDouble {
    type Output = Self;

    fn neg(self) -> Self {
        Self {
            high: -self.high,
            low: -self.low,
        }
    }
}

impl Sub for DoubleDouble {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for DoubleDouble {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        let (high, error) = two_product(self.high, other.high);
        let mixed = self.high * other.low + self.low * other.high;
        Self::normalized(high, error + mixed)
    }
}

impl Div for DoubleDouble {
    type Output = Self;

    /// Long division with three digits, which are numbers of `f64`.
    fn div(self, other: Self) -> Self {
        let first = self.high / other.high;
        if !first.is_finite() || other.high.is_infinite() {
            return Self::from_f64(first);
        }
        let rest = self - other * Self::from_f64(first);
        let second = rest.high / other.high;
        let rest = rest - other * Self::from_f64(second);
        let third = rest.high / other.high;
        Self::normalized(first, second) + Self::from_f64(third)
    }
}

arithmetic!(DoubleDouble);

impl Scalar for DoubleDouble {
    fn from_f64(value: f64) -> Self {
        Self {
            high: value,
            low: 0.0,
        }
    }

    fn ratio(numerator: f64, denominator: f64) -> Self {
        Self::from_f64(numerator) / Self::from_f64(denominator)
    }

    fn pi() -> Self {
        PI
    }

    fn smallest(self) -> f64 {
        self.high
    }

    fn largest(self) -> f64 {
        self.high
    }

    fn machine_epsilon() -> f64 {
        f64::EPSILON * f64::EPSILON
    }

    fn sin_cos(self) -> (Self, Self) {
        let (quarters, rest) = self.reduced(PI.times_power_of_two(-1.0));
        let (sine, cosine) = (rest.series(1, -1.0), rest.series(0, -1.0));
        match quarters.rem_euclid(4.0) {
            1.0 => (cosine, -sine),
            2.0 => (-sine, -cosine),
            3.0 => (-cosine, sine),
            _ => (sine, cosine),
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
        self.atan2(((Self::one() - self) * (Self::one() + self)).sqrt())
    }

    fn acos(self) -> Self {
        ((Self::one() - self) * (Self::one() + self))
            .sqrt()
            .atan2(self)
    }

    fn atan(self) -> Self {
        self.atan2(Self::one())
    }

    /// From the angle of `f64`, turned by what is left: its tangent is the angle but for a cube.
    fn atan2(self, x: Self) -> Self {
        let angle = Self::from_f64(self.high.atan2(x.high));
        if (self.is_zero() && x.is_zero()) || !self.is_finite() || !x.is_finite() {
            return angle;
        }
        let (sine, cosine) = angle.sin_cos();
        angle + (self * cosine - x * sine) / (x * cosine + self * sine)
    }

    fn sinh(self) -> Self {
        if self.high.abs() < 1.0 {
            return self.series(1, 1.0);
        }
        let growing = self.exp();
        (growing - growing.recip()).times_power_of_two(-1.0)
    }

    fn cosh(self) -> Self {
        let growing = self.exp();
        (growing + growing.recip()).times_power_of_two(-1.0)
    }

    fn tanh(self) -> Self {
        // Beyond it is ±1 to all digits, and the exponential overflows.
        if self.high.abs() > 40.0 {
            return self.signum();
        }
        self.sinh() / self.cosh()
    }

    fn asinh(self) -> Self {
        self.refined(self.high.asinh(), Self::sinh, Self::cosh)
    }

    fn acosh(self) -> Self {
        self.refined(self.high.acosh(), Self::cosh, Self::sinh)
    }

    fn atanh(self) -> Self {
        let slope = |y: Self| (y.cosh() * y.cosh()).recip();
        self.refined(self.high.atanh(), Self::tanh, slope)
    }

    fn exp(self) -> Self {
        if self.high.abs() > 709.0 || self.high.is_nan() {
            return Self::from_f64(self.high.exp());
        }
        let (twos, rest) = self.reduced(LN_2);
        (rest.series(1, 1.0) + rest.series(0, 1.0)).times_power_of_two(twos)
    }

    fn ln(self) -> Self {
        self.refined(self.high.ln(), Self::exp, Self::exp)
    }

    fn sqrt(self) -> Self {
        let slope = |y: Self| y.times_power_of_two(1.0);
        self.refined(self.high.sqrt(), |y| y * y, slope)
    }

    fn powf(self, exponent: Self) -> Self {
        let power = || (self.abs().ln() * exponent).exp();
        let whole = exponent.low.abs() <= 0.0 && exponent.high.fract().abs() <= 0.0;
        if self.is_zero() || !self.is_finite() || !exponent.is_finite() {
            Self::from_f64(self.high.powf(exponent.high))
        } else if !self.is_negative() {
            power()
        } else if !whole {
            Self::from_f64(f64::NAN)
        } else if exponent.high.rem_euclid(2.0) > 0.0 {
            -power()
        } else {
            power()
        }
    }

    fn abs(self) -> Self {
        if self.is_negative() { -self } else { self }
    }

    fn signum(self) -> Self {
        Self::from_f64(Scalar::signum(self.high))
    }

    fn min(self, other: Self) -> Self {
        if other < self { other } else { self }
    }

    fn max(self, other: Self) -> Self {
        if other > self { other } else { self }
    }
}

impl DoubleDouble {
    fn recip(self) -> Self {
        Self::one() / self
    }
}
