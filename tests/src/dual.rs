//! Dual numbers as a scalar of derived models: the scalar that users would write for a type of
//! theirs.

use std::ops::{Add, Div, Mul, Neg, Sub};

use lagrangian::Scalar;
use num_dual::{Dual64, DualNum};

use crate::arithmetic::arithmetic;

/// A value and its derivative in one direction.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Dual(Dual64);

impl Dual {
    /// The value `value`, moving at the rate `derivative`.
    #[must_use]
    pub fn new(value: f64, derivative: f64) -> Self {
        Self(Dual64::new(value, derivative))
    }

    /// A value that does not move.
    #[must_use]
    pub fn constant(value: f64) -> Self {
        Self::new(value, 0.0)
    }

    /// The value.
    #[must_use]
    pub fn value(self) -> f64 {
        self.0.re
    }

    /// The rate at which the value moves.
    #[must_use]
    pub fn derivative(self) -> f64 {
        self.0.eps
    }
}

macro_rules! operators {
    ($($operator:ident $function:ident)*) => {$(
        impl $operator for Dual {
            type Output = Self;

            fn $function(self, other: Self) -> Self {
                Self($operator::$function(self.0, other.0))
            }
        }
    )*};
}

operators! { Add add Sub sub Mul mul Div div }

impl Neg for Dual {
    type Output = Self;

    fn neg(self) -> Self {
        Self(-self.0)
    }
}

arithmetic!(Dual);

macro_rules! forwarded {
    ($($function:ident)*) => {$(
        fn $function(self) -> Self {
            Self(DualNum::$function(&self.0))
        }
    )*};
}

impl Scalar for Dual {
    forwarded! { sin cos tan asin acos atan sinh cosh tanh asinh acosh atanh exp ln }

    fn from_f64(value: f64) -> Self {
        Self::constant(value)
    }

    fn sqrt(self) -> Self {
        if self == Self::constant(0.0) {
            return self;
        }
        Self(DualNum::sqrt(&self.0))
    }

    fn smallest(self) -> f64 {
        self.value()
    }

    fn largest(self) -> f64 {
        self.value()
    }

    fn atan2(self, x: Self) -> Self {
        // Scaled, so that the squares of neither underflow or overflow.
        let scale = self.value().common_scale(x.value());
        Self(DualNum::atan2(&(self.0 * scale), x.0 * scale))
    }

    fn common_scale(self, other: Self) -> Self {
        Self::constant(self.value().common_scale(other.value()))
    }

    // A constant exponent is the case with a value for every base that real numbers allow.
    fn powf(self, exponent: Self) -> Self {
        if exponent.derivative() == 0.0 {
            Self(DualNum::powf(&self.0, exponent.value()))
        } else {
            Self(DualNum::powd(&self.0, exponent.0))
        }
    }

    fn abs(self) -> Self {
        self * self.signum()
    }

    fn signum(self) -> Self {
        Self::constant(Scalar::signum(self.value()))
    }

    fn min(self, other: Self) -> Self {
        if other.value() < self.value() {
            other
        } else {
            self
        }
    }

    fn max(self, other: Self) -> Self {
        if other.value() > self.value() {
            other
        } else {
            self
        }
    }
}
