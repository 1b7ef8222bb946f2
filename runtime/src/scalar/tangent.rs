//! Dual numbers with several derivative parts on any scalar: forward-mode automatic differentiation (Griewank and Walther,
//! Evaluating Derivatives, 2008, chapter 3).
//!
//! Emitted code computes derivatives of models of many coordinates on them: one evaluation of the inverse dynamics gives as many
//! columns. The operations are inlined. As functions of their own, with results in memory, LLVM 22 took two minutes to move those
//! of a chain of 100 links from one place on the stack to another.

use core::array::from_fn;
use core::ops::{Add, Div, Mul, Neg, Sub};

use num_traits::Zero;

use super::Scalar;
use super::arithmetic::arithmetic;

/// A number, and its derivatives in `D` directions.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tangent<S, const D: usize> {
    value: S,
    slopes: [S; D],
}

impl<S: Scalar, const D: usize> Tangent<S, D> {
    /// A number with no derivatives.
    #[inline]
    pub fn constant(value: S) -> Self {
        Self {
            value,
            slopes: from_fn(|_| S::zero()),
        }
    }

    /// The number that a direction leads along: its derivative there is 1. In directions that there are not, it has none.
    pub fn variable(value: S, direction: Option<usize>) -> Self {
        let slope = |k| {
            if direction == Some(k) {
                S::one()
            } else {
                S::zero()
            }
        };
        Self {
            value,
            slopes: from_fn(slope),
        }
    }

    /// The derivatives.
    #[inline]
    pub fn slopes(self) -> [S; D] {
        self.slopes
    }

    /// f(self), from f and f′ there.
    #[inline]
    fn chain(self, value: S, derivative: S) -> Self {
        Self {
            value,
            slopes: self.slopes.map(|slope| slope * derivative),
        }
    }

    /// f(self, other), from f and both partial derivatives there.
    #[inline]
    fn chain_of_two(self, other: Self, value: S, [first, second]: [S; 2]) -> Self {
        let slope = |k: usize| self.slopes[k].mul_add(first, other.slopes[k] * second);
        Self {
            value,
            slopes: from_fn(slope),
        }
    }

    #[inline]
    fn quotient(self, other: Self) -> Self {
        let value = self.value / other.value;
        let slope = |k: usize| (self.slopes[k] - value * other.slopes[k]) / other.value;
        Self {
            value,
            slopes: from_fn(slope),
        }
    }

    fn is_constant(self) -> bool {
        self.slopes.iter().all(Zero::is_zero)
    }
}

impl<S: Scalar, const D: usize> Neg for Tangent<S, D> {
    type Output = Self;

    #[inline]
    fn neg(self) -> Self {
        Self {
            value: -self.value,
            slopes: self.slopes.map(|slope| -slope),
        }
    }
}

impl<S: Scalar, const D: usize> Add for Tangent<S, D> {
    type Output = Self;

    #[inline]
    fn add(self, other: Self) -> Self {
        Self {
            value: self.value + other.value,
            slopes: from_fn(|k| self.slopes[k] + other.slopes[k]),
        }
    }
}

impl<S: Scalar, const D: usize> Sub for Tangent<S, D> {
    type Output = Self;

    #[inline]
    fn sub(self, other: Self) -> Self {
        Self {
            value: self.value - other.value,
            slopes: from_fn(|k| self.slopes[k] - other.slopes[k]),
        }
    }
}

impl<S: Scalar, const D: usize> Mul for Tangent<S, D> {
    type Output = Self;

    #[inline]
    fn mul(self, other: Self) -> Self {
        let slope = |k: usize| self.slopes[k].mul_add(other.value, self.value * other.slopes[k]);
        Self {
            value: self.value * other.value,
            slopes: from_fn(slope),
        }
    }
}

impl<S: Scalar, const D: usize> Div for Tangent<S, D> {
    type Output = Self;

    #[inline]
    fn div(self, other: Self) -> Self {
        self.quotient(other)
    }
}

arithmetic! { [S: Scalar, const D: usize] Tangent<S, D> }

impl<S: Scalar, const D: usize> Scalar for Tangent<S, D> {
    #[inline]
    fn from_f64(value: f64) -> Self {
        Self::constant(S::from_f64(value))
    }

    fn ratio(numerator: f64, denominator: f64) -> Self {
        Self::constant(S::ratio(numerator, denominator))
    }

    fn pi() -> Self {
        Self::constant(S::pi())
    }

    fn min_positive() -> Self {
        Self::constant(S::min_positive())
    }

    fn smallest(self) -> f64 {
        self.value.smallest()
    }

    fn largest(self) -> f64 {
        self.value.largest()
    }

    fn in_lane(self, lane: usize) -> f64 {
        self.value.in_lane(lane)
    }

    fn machine_epsilon() -> f64 {
        S::machine_epsilon()
    }

    #[inline]
    fn mul_add(self, factor: Self, summand: Self) -> Self {
        let slope = |k: usize| {
            let rest = self.value.mul_add(factor.slopes[k], summand.slopes[k]);
            self.slopes[k].mul_add(factor.value, rest)
        };
        Self {
            value: self.value.mul_add(factor.value, summand.value),
            slopes: from_fn(slope),
        }
    }

    fn sin_cos(self) -> (Self, Self) {
        let (sine, cosine) = self.value.sin_cos();
        (self.chain(sine, cosine), self.chain(cosine, -sine))
    }

    fn sines_and_cosines<const K: usize>(angles: [Self; K]) -> ([Self; K], [Self; K]) {
        let (sines, cosines) = S::sines_and_cosines(angles.map(|angle| angle.value));
        (
            from_fn(|i| angles[i].chain(sines[i], cosines[i])),
            from_fn(|i| angles[i].chain(cosines[i], -sines[i])),
        )
    }

    fn sin(self) -> Self {
        self.sin_cos().0
    }

    fn cos(self) -> Self {
        self.sin_cos().1
    }

    fn tan(self) -> Self {
        let tangent = self.value.tan();
        self.chain(tangent, S::one() + tangent * tangent)
    }

    fn asin(self) -> Self {
        let leg = (S::one() - self.value) * (S::one() + self.value);
        self.chain(self.value.asin(), S::one() / leg.sqrt())
    }

    fn acos(self) -> Self {
        let leg = (S::one() - self.value) * (S::one() + self.value);
        self.chain(self.value.acos(), -S::one() / leg.sqrt())
    }

    fn atan(self) -> Self {
        let square = self.value * self.value;
        self.chain(self.value.atan(), S::one() / (S::one() + square))
    }

    fn atan2(self, x: Self) -> Self {
        let scale = self.value.common_scale(x.value);
        let (sine, cosine) = (self.value * scale, x.value * scale);
        let square = sine * sine + cosine * cosine;
        let slopes = [cosine / square * scale, -sine / square * scale];
        self.chain_of_two(x, self.value.atan2(x.value), slopes)
    }

    fn common_scale(self, other: Self) -> Self {
        Self::constant(self.value.common_scale(other.value))
    }

    fn sinh(self) -> Self {
        self.chain(self.value.sinh(), self.value.cosh())
    }

    fn cosh(self) -> Self {
        self.chain(self.value.cosh(), self.value.sinh())
    }

    fn tanh(self) -> Self {
        let tangent = self.value.tanh();
        self.chain(tangent, S::one() - tangent * tangent)
    }

    fn asinh(self) -> Self {
        let square = self.value * self.value + S::one();
        self.chain(self.value.asinh(), S::one() / square.sqrt())
    }

    fn acosh(self) -> Self {
        let square = (self.value - S::one()) * (self.value + S::one());
        self.chain(self.value.acosh(), S::one() / square.sqrt())
    }

    fn atanh(self) -> Self {
        let square = (S::one() - self.value) * (S::one() + self.value);
        self.chain(self.value.atanh(), S::one() / square)
    }

    fn exp(self) -> Self {
        let power = self.value.exp();
        self.chain(power, power)
    }

    fn ln(self) -> Self {
        self.chain(self.value.ln(), S::one() / self.value)
    }

    fn sech(self) -> Self {
        let value = self.value.sech();
        self.chain(value, -(value * self.value.tanh()))
    }

    fn logistic(self) -> Self {
        let value = self.value.logistic();
        self.chain(value, value * (-self.value).logistic())
    }

    fn log_cosh(self) -> Self {
        self.chain(self.value.log_cosh(), self.value.tanh())
    }

    fn softplus(self) -> Self {
        self.chain(self.value.softplus(), self.value.logistic())
    }

    // The slope of a root is infinite at 0; where the radicand has none, neither has the root.
    fn sqrt(self) -> Self {
        let root = self.value.sqrt();
        let twice = root + root + S::min_positive();
        Self {
            value: root,
            slopes: self.slopes.map(|slope| slope / twice),
        }
    }

    // With a constant exponent there is a slope for every base that has a real power.
    fn powf(self, exponent: Self) -> Self {
        let value = self.value.powf(exponent.value);
        // 1 where a number is 0, and 0 elsewhere: x⁰ has the slope 0 at 0, too, and xʸ ln x counts as 0 there.
        let guard = |x: S| S::one() - x.signum() * x.signum();
        let less = exponent.value - S::one() + guard(exponent.value);
        let by_base = exponent.value * self.value.powf(less);
        if exponent.is_constant() {
            self.chain(value, by_base)
        } else {
            let logarithm = (self.value + guard(self.value)).ln();
            self.chain_of_two(exponent, value, [by_base, value * logarithm])
        }
    }

    fn abs(self) -> Self {
        self.chain(self.value.abs(), self.value.signum())
    }

    fn signum(self) -> Self {
        Self::constant(self.value.signum())
    }

    fn floor(self) -> Self {
        Self::constant(self.value.floor())
    }

    fn min(self, other: Self) -> Self {
        let other_is_less = (self.value - other.value).signum().max(S::zero());
        let weights = [S::one() - other_is_less, other_is_less];
        self.chain_of_two(other, self.value.min(other.value), weights)
    }

    fn max(self, other: Self) -> Self {
        let other_is_greater = (other.value - self.value).signum().max(S::zero());
        let weights = [S::one() - other_is_greater, other_is_greater];
        self.chain_of_two(other, self.value.max(other.value), weights)
    }
}

#[cfg(test)]
mod tests;
