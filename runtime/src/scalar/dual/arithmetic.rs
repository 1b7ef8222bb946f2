//! Sums, differences, products and quotients of dual numbers: Griewank and Walther 2008, table 2.3.

use core::array::from_fn;
use core::ops::{Add, Div, Mul, Neg, Sub};

use num_traits::{One, Zero};

use super::Dual;
use crate::scalar::Scalar;
use crate::scalar::arithmetic::assigning;

impl<S: Scalar, const N: usize> Dual<S, N> {
    #[inline]
    fn quotient(self, other: Self) -> Self {
        let value = self.value / other.value;
        let slope = |k: usize| (self.derivative[k] - value * other.derivative[k]) / other.value;
        Self {
            value,
            derivative: from_fn(slope),
        }
    }
}

impl<S: Scalar, const N: usize> Neg for Dual<S, N> {
    type Output = Self;

    #[inline]
    fn neg(self) -> Self {
        Self {
            value: -self.value,
            derivative: self.derivative.map(|slope| -slope),
        }
    }
}

impl<S: Scalar, const N: usize> Add for Dual<S, N> {
    type Output = Self;

    #[inline]
    fn add(self, other: Self) -> Self {
        Self {
            value: self.value + other.value,
            derivative: from_fn(|k| self.derivative[k] + other.derivative[k]),
        }
    }
}

impl<S: Scalar, const N: usize> Sub for Dual<S, N> {
    type Output = Self;

    #[inline]
    fn sub(self, other: Self) -> Self {
        Self {
            value: self.value - other.value,
            derivative: from_fn(|k| self.derivative[k] - other.derivative[k]),
        }
    }
}

impl<S: Scalar, const N: usize> Mul for Dual<S, N> {
    type Output = Self;

    #[inline]
    fn mul(self, other: Self) -> Self {
        let slope =
            |k: usize| self.derivative[k].mul_add(other.value, self.value * other.derivative[k]);
        Self {
            value: self.value * other.value,
            derivative: from_fn(slope),
        }
    }
}

impl<S: Scalar, const N: usize> Div for Dual<S, N> {
    type Output = Self;

    #[inline]
    fn div(self, other: Self) -> Self {
        self.quotient(other)
    }
}

assigning! { [S: Scalar, const N: usize] Dual<S, N> }

impl<S: Scalar, const N: usize> Zero for Dual<S, N> {
    #[inline]
    fn zero() -> Self {
        Self::constant(S::zero())
    }

    /// Returns whether the value and all derivatives are zero.
    #[inline]
    fn is_zero(&self) -> bool {
        self.value.is_zero() && self.is_constant()
    }
}

impl<S: Scalar, const N: usize> One for Dual<S, N> {
    #[inline]
    fn one() -> Self {
        Self::constant(S::one())
    }
}

/// Implements an operator whose right operand is a constant number, given the derivative of the result.
macro_rules! with_number {
    ($operator:ident $function:ident, |$derivative:ident, $number:ident| $result:expr) => {
        /// The operator with a constant number as the right operand.
        impl<S: Scalar, const N: usize> $operator<f64> for Dual<S, N> {
            type Output = Self;

            #[inline]
            fn $function(self, number: f64) -> Self {
                let ($derivative, $number) = (self.derivative, S::from_f64(number));
                Self {
                    value: $operator::$function(self.value, $number),
                    derivative: $result,
                }
            }
        }
    };
}

with_number! { Add add, |derivative, _number| derivative }
with_number! { Sub sub, |derivative, _number| derivative }
with_number! { Mul mul, |derivative, factor| derivative.map(|slope| slope * factor) }
with_number! { Div div, |derivative, divisor| derivative.map(|slope| slope / divisor) }
