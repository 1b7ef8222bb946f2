//! Numbers with their first and second rates, so that dots in print have values.

use core::ops::{Add, Div, Mul, Neg, Sub};

/// A value, its rate, and the rate of that.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) struct Jet(pub(super) [f64; 3]);

impl Jet {
    pub(super) const ZERO: Self = Self([0.0; 3]);
    pub(super) const ONE: Self = Self([1.0, 0.0, 0.0]);

    pub(super) const fn constant(value: f64) -> Self {
        Self([value, 0.0, 0.0])
    }

    pub(super) const fn value(self) -> f64 {
        self.0[0]
    }

    /// Whether it vanishes, as far as it is known.
    pub(super) fn is_zero(self) -> bool {
        self.0.iter().all(|x| *x == 0.0 || x.is_nan()) && self.value() == 0.0
    }

    /// Its rate, of which the second rate is not known.
    pub(super) const fn rate(self) -> Self {
        Self([self.0[1], self.0[2], f64::NAN])
    }

    /// A function of it with these values of the function and its two derivatives.
    fn composed(self, [f, f1, f2]: [f64; 3]) -> Self {
        let [_, x1, x2] = self.0;
        Self([f, f1 * x1, times(f2, x1 * x1) + f1 * x2])
    }

    fn times(self, other: Self) -> Self {
        let ([x, x1, x2], [y, y1, y2]) = (self.0, other.0);
        Self([x * y, x1 * y + x * y1, x2 * y + 2.0 * x1 * y1 + x * y2])
    }

    fn reciprocal(self) -> Self {
        let x = self.value();
        self.composed([1.0 / x, -1.0 / (x * x), 2.0 / (x * x * x)])
    }

    pub(super) fn sqrt(self) -> Self {
        let root = self.value().sqrt();
        let x = self.value();
        self.composed([root, 0.5 / root, -0.25 / (root * x)])
    }

    pub(super) fn abs(self) -> Self {
        let sign = self.value().signum();
        self.composed([self.value().abs(), sign, 0.0])
    }

    /// x^y, of which y is constant where x is not positive.
    pub(super) fn power(self, y: Self) -> Self {
        let (x, k) = (self.value(), y.value());
        if y.0[1] == 0.0 && y.0[2] == 0.0 {
            let first = times(k, x.powf(k - 1.0));
            return self.composed([x.powf(k), first, times(k * (k - 1.0), x.powf(k - 2.0))]);
        }
        (y * self.function("ln").unwrap_or(Self::ZERO))
            .function("exp")
            .unwrap_or(Self::ZERO)
    }

    /// A function of one argument, by the name that books give it.
    pub(super) fn function(self, name: &str) -> Option<Self> {
        let x = self.value();
        let square = x * x;
        let derivatives = match name {
            "sin" => [x.sin(), x.cos(), -x.sin()],
            "cos" => [x.cos(), -x.sin(), -x.cos()],
            "tan" => {
                let slope = 1.0 / (x.cos() * x.cos());
                [x.tan(), slope, 2.0 * x.tan() * slope]
            }
            "arcsin" => {
                let slope = 1.0 / (1.0 - square).sqrt();
                [x.asin(), slope, x * slope.powi(3)]
            }
            "arccos" => {
                let slope = -1.0 / (1.0 - square).sqrt();
                [x.acos(), slope, x * slope.powi(3)]
            }
            "arctan" => {
                let slope = 1.0 / (1.0 + square);
                [x.atan(), slope, -2.0 * x * slope * slope]
            }
            "sinh" => [x.sinh(), x.cosh(), x.sinh()],
            "cosh" => [x.cosh(), x.sinh(), x.cosh()],
            "tanh" => {
                let slope = 1.0 / (x.cosh() * x.cosh());
                [x.tanh(), slope, -2.0 * x.tanh() * slope]
            }
            "arsinh" => {
                let slope = 1.0 / (1.0 + square).sqrt();
                [x.asinh(), slope, -x * slope.powi(3)]
            }
            "arcosh" => {
                let slope = 1.0 / (square - 1.0).sqrt();
                [x.acosh(), slope, -x * slope.powi(3)]
            }
            "artanh" => {
                let slope = 1.0 / (1.0 - square);
                [x.atanh(), slope, 2.0 * x * slope * slope]
            }
            "exp" => [x.exp(); 3],
            "ln" => [x.ln(), 1.0 / x, -1.0 / square],
            "sgn" => [if x == 0.0 { 0.0 } else { x.signum() }, 0.0, 0.0],
            "abs" => return Some(self.abs()),
            _ => return None,
        };
        Some(self.composed(derivatives))
    }

    /// The angle of the point (x, y).
    pub(super) fn atan2(y: Self, x: Self) -> Self {
        let ratio = if x.value().abs() > y.value().abs() {
            (y / x).function("arctan")
        } else {
            (-x / y).function("arctan")
        };
        let Self([_, first, second]) = ratio.unwrap_or(Self::ZERO);
        Self([y.value().atan2(x.value()), first, second])
    }
}

/// A product in which 0 times an infinity is 0: derivatives of powers at 0.
fn times(x: f64, y: f64) -> f64 {
    if x == 0.0 { 0.0 } else { x * y }
}

impl Add for Jet {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self([0, 1, 2].map(|k| self.0[k] + other.0[k]))
    }
}

impl Neg for Jet {
    type Output = Self;
    fn neg(self) -> Self {
        Self(self.0.map(|x| -x))
    }
}

impl Sub for Jet {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for Jet {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        self.times(other)
    }
}

impl Div for Jet {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        let reciprocal = other.reciprocal();
        self.times(reciprocal)
    }
}
