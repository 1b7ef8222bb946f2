//! Dual numbers as a scalar of derived models: the scalar that users would write for a type of theirs, with the methods of
//! [`Scalar`] that have no default and those that its documentation asks of dual numbers.

use std::ops::{Add, Div, Mul, Neg, Sub};

use lagrangian::Scalar;

use crate::arithmetic::arithmetic;

/// A value and its derivative in one direction.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Dual {
    value: f64,
    derivative: f64,
}

impl Dual {
    /// The value `value`, moving at the rate `derivative`.
    #[must_use]
    pub fn new(value: f64, derivative: f64) -> Self {
        Self { value, derivative }
    }

    /// A value that does not move.
    #[must_use]
    pub fn constant(value: f64) -> Self {
        Self::new(value, 0.0)
    }

    /// The value.
    #[must_use]
    pub fn value(self) -> f64 {
        self.value
    }

    /// The rate at which the value moves.
    #[must_use]
    pub fn derivative(self) -> f64 {
        self.derivative
    }

    /// A function of this number, from its value and slope here.
    fn through(self, value: f64, slope: f64) -> Self {
        Self::new(value, slope * self.derivative)
    }
}

impl Add for Dual {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self::new(self.value + other.value, self.derivative + other.derivative)
    }
}

impl Sub for Dual {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for Dual {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        let slope = self.derivative * other.value + self.value * other.derivative;
        Self::new(self.value * other.value, slope)
    }
}

impl Div for Dual {
    type Output = Self;

    fn div(self, other: Self) -> Self {
        let quotient = self.value / other.value;
        let slope = (self.derivative - quotient * other.derivative) / other.value;
        Self::new(quotient, slope)
    }
}

impl Neg for Dual {
    type Output = Self;

    fn neg(self) -> Self {
        Self::new(-self.value, -self.derivative)
    }
}

arithmetic!(Dual);

macro_rules! functions {
    ($($function:ident: |$x:ident, $value:ident| $slope:expr;)*) => {$(
        fn $function(self) -> Self {
            let $x = self.value;
            let $value = f64::$function($x);
            self.through($value, $slope)
        }
    )*};
}

impl Scalar for Dual {
    functions! {
        sin: |x, _sine| x.cos();
        cos: |x, _cosine| -x.sin();
        tan: |x, _tangent| 1.0 / (x.cos() * x.cos());
        asin: |x, _angle| 1.0 / (1.0 - x * x).sqrt();
        acos: |x, _angle| -1.0 / (1.0 - x * x).sqrt();
        atan: |x, _angle| 1.0 / (1.0 + x * x);
        sinh: |x, _sine| x.cosh();
        cosh: |x, _cosine| x.sinh();
        tanh: |x, _tangent| 1.0 / (x.cosh() * x.cosh());
        asinh: |x, _area| 1.0 / (x * x + 1.0).sqrt();
        acosh: |x, _area| 1.0 / (x * x - 1.0).sqrt();
        atanh: |x, _area| 1.0 / (1.0 - x * x);
        exp: |_x, power| power;
        ln: |x, _logarithm| 1.0 / x;
    }

    fn from_f64(value: f64) -> Self {
        Self::constant(value)
    }

    fn sqrt(self) -> Self {
        if self == Self::constant(0.0) {
            return self;
        }
        let root = self.value.sqrt();
        self.through(root, 0.5 / root)
    }

    fn smallest(self) -> f64 {
        self.value
    }

    fn largest(self) -> f64 {
        self.value
    }

    fn atan2(self, x: Self) -> Self {
        // Scaled, so that the squares of neither underflow or overflow.
        let scale = self.value.common_scale(x.value);
        let [sine, cosine] = [self.value * scale, x.value * scale];
        let area = cosine * (self.derivative * scale) - sine * (x.derivative * scale);
        let slope = area / (sine * sine + cosine * cosine);
        Self::new(self.value.atan2(x.value), slope)
    }

    fn common_scale(self, other: Self) -> Self {
        Self::constant(self.value.common_scale(other.value))
    }

    // A constant exponent is the case with a value for every base that real numbers allow.
    fn powf(self, exponent: Self) -> Self {
        let power = self.value.powf(exponent.value);
        let mut slope = 0.0;
        if self.derivative != 0.0 && exponent.value != 0.0 {
            slope += exponent.value * self.value.powf(exponent.value - 1.0) * self.derivative;
        }
        if exponent.derivative != 0.0 {
            slope += power * self.value.ln() * exponent.derivative;
        }
        Self::new(power, slope)
    }

    fn abs(self) -> Self {
        self * self.signum()
    }

    fn signum(self) -> Self {
        Self::constant(Scalar::signum(self.value))
    }

    fn min(self, other: Self) -> Self {
        if other.value < self.value {
            other
        } else {
            self
        }
    }

    fn max(self, other: Self) -> Self {
        if other.value > self.value {
            other
        } else {
            self
        }
    }
}
