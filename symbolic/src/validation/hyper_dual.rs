//! Hyper-dual numbers x + ẋ ε₁ + x′ ε₂ + ẋ′ ε₁ε₂ with ε₁² = ε₂² = 0 (Fike and Alonso, The development of
//! hyper-dual numbers for exact second-derivative calculations, 2011).
//!
//! What is computed on them has its derivatives along two directions beside its value, and the mixed second
//! one. Functions come with three derivatives, so that slopes can be computed on them, too.
#![allow(clippy::float_cmp)] // Exponents are exact, and kinks are where arguments are equal.

#[cfg(test)]
mod tests;

use core::ops::{Add, Div, Mul, Neg, Sub};

use crate::validation::number::{Number, real_power};
use crate::{Binary, Unary};

/// A number with derivatives along two directions.
#[derive(Clone, Copy, PartialEq, Default, Debug)]
pub(crate) struct HyperDual {
    pub(crate) value: f64,
    /// Along the first direction.
    pub(crate) first: f64,
    /// Along the second direction.
    pub(crate) second: f64,
    /// Along both.
    pub(crate) mixed: f64,
}

/// f, f′, f″ and f‴ at a number.
pub(super) type Derivatives = [f64; 4];

impl HyperDual {
    pub(crate) fn is_zero(self) -> bool {
        self == Self::default()
    }

    pub(crate) const fn is_finite(self) -> bool {
        self.value.is_finite()
            && self.first.is_finite()
            && self.second.is_finite()
            && self.mixed.is_finite()
    }

    /// f(x) by f, f′ and f″ at the value of x.
    fn lifted(self, f: f64, slope: f64, curvature: f64) -> Self {
        Self {
            value: f,
            first: slope * self.first,
            second: slope * self.second,
            mixed: slope * self.mixed + curvature * self.first * self.second,
        }
    }

    /// 1/x.
    pub(crate) fn reciprocal(self) -> Self {
        self.power(-1.0)
    }

    /// x/2ⁿ and 2ⁿ for the 2ⁿ next to |x|, unless one of them is not in the range of numbers.
    fn by_size(self) -> Option<(Self, f64)> {
        let size = libm::ldexp(1.0, libm::ilogb(self.value).clamp(-1020, 1020));
        let is_in_range = self.value.is_normal() && (1.0 / size).is_normal();
        is_in_range.then(|| (self.scaled(1.0 / size), size))
    }

    /// ∂(x^k)/∂x.
    pub(crate) fn power_slope(self, k: f64) -> Self {
        let Some((unit, size)) = self.by_size() else {
            let [_, slope, curvature, third] = power_derivatives(self.value, k);
            return self.lifted(slope, curvature, third);
        };
        let [_, slope, curvature, third] = power_derivatives(unit.value, k);
        let scaled = unit.lifted(slope, curvature, third);
        scaled.scaled(real_power(size, k - 1.0))
    }

    /// f′(x).
    pub(crate) fn slope(self, function: Unary) -> Self {
        let [_, slope, curvature, third] = derivatives(function, self.value);
        self.lifted(slope, curvature, third)
    }

    /// ∂f/∂x and ∂f/∂y.
    pub(crate) fn slopes(self, function: Binary, y: Self) -> [Self; 2] {
        let (zero, one) = (Self::default(), Self::constant(1.0));
        match function {
            Binary::Atan2 => {
                let inverse = (self * self + y * y).reciprocal();
                [y * inverse, -(self * inverse)]
            }
            // The mean of both sides, as the derivatives in the table have it.
            Binary::Min | Binary::Max if self.value == y.value => [Self::constant(0.5); 2],
            Binary::Min if self.value < y.value => [one, zero],
            Binary::Max if self.value > y.value => [one, zero],
            Binary::Min | Binary::Max => [zero, one],
            Binary::Scale => [zero, zero],
            Binary::Power => {
                // x^y = exp (y ln x).
                let logarithm = self.unary(Unary::Ln);
                let power = (y * logarithm).unary(Unary::Exp);
                [y * power * self.reciprocal(), power * logarithm]
            }
        }
    }
}

impl Number for HyperDual {
    fn constant(value: f64) -> Self {
        Self {
            value,
            ..Self::default()
        }
    }

    fn value(self) -> f64 {
        self.value
    }

    fn scaled(self, factor: f64) -> Self {
        Self {
            value: self.value * factor,
            first: self.first * factor,
            second: self.second * factor,
            mixed: self.mixed * factor,
        }
    }

    fn shifted(self, distance: f64) -> Self {
        let shift = Self {
            value: distance,
            first: distance,
            second: distance,
            mixed: distance,
        };
        self + shift
    }

    fn power(self, k: f64) -> Self {
        // |x|ᵏ (x/|x|)ᵏ: higher powers of a large value, as in the derivatives of 1/x, are lost below the smallest number.
        let Some((unit, size)) = self.by_size() else {
            let [f, slope, curvature, _] = power_derivatives(self.value, k);
            return self.lifted(f, slope, curvature);
        };
        let [f, slope, curvature, _] = power_derivatives(unit.value, k);
        unit.lifted(f, slope, curvature).scaled(real_power(size, k))
    }

    fn unary(self, function: Unary) -> Self {
        let [f, slope, curvature, _] = derivatives(function, self.value);
        self.lifted(f, slope, curvature)
    }

    fn binary(self, function: Binary, y: Self) -> Self {
        let value = function.value(self.value, y.value);
        Self::composed(value, &self.slopes(function, y), &[self, y])
    }

    fn composed(value: f64, slopes: &[Self], arguments: &[Self]) -> Self {
        let mut result = Self::constant(value);
        for (slope, x) in slopes.iter().zip(arguments) {
            result.first += slope.value * x.first;
            result.second += slope.value * x.second;
            result.mixed += slope.value * x.mixed + slope.second * x.first;
        }
        result
    }
}

impl Add for HyperDual {
    type Output = Self;

    fn add(self, y: Self) -> Self {
        Self {
            value: self.value + y.value,
            first: self.first + y.first,
            second: self.second + y.second,
            mixed: self.mixed + y.mixed,
        }
    }
}

impl Sub for HyperDual {
    type Output = Self;

    fn sub(self, y: Self) -> Self {
        Self {
            value: self.value - y.value,
            first: self.first - y.first,
            second: self.second - y.second,
            mixed: self.mixed - y.mixed,
        }
    }
}

impl Neg for HyperDual {
    type Output = Self;

    fn neg(self) -> Self {
        self.scaled(-1.0)
    }
}

impl Mul for HyperDual {
    type Output = Self;

    fn mul(self, y: Self) -> Self {
        Self {
            value: self.value * y.value,
            first: self.first * y.value + self.value * y.first,
            second: self.second * y.value + self.value * y.second,
            mixed: self.mixed * y.value
                + self.first * y.second
                + self.second * y.first
                + self.value * y.mixed,
        }
    }
}

impl Div for HyperDual {
    type Output = Self;

    fn div(self, y: Self) -> Self {
        self * y.power(-1.0)
    }
}

/// xᵏ and its derivatives, without 0·∞ where a derivative of a low power vanishes identically.
pub(super) fn power_derivatives(x: f64, k: f64) -> Derivatives {
    if k == 2.0 {
        return [x * x, 2.0 * x, 2.0, 0.0];
    }
    let mut derivatives = [0.0; 4];
    let mut factor = 1.0;
    let mut exponent = k;
    for derivative in &mut derivatives {
        if factor != 0.0 {
            *derivative = factor * real_power(x, exponent);
        }
        factor *= exponent;
        exponent -= 1.0;
    }
    derivatives
}

/// Of a function with f″ = −f.
const fn alternating(f: f64, slope: f64) -> Derivatives {
    [f, slope, -f, -slope]
}

/// Of a function with f″ = f.
const fn repeating(f: f64, slope: f64) -> Derivatives {
    [f, slope, f, slope]
}

/// Of the inverse sine with the sign 1, and of the inverse cosine with −1.
fn inverse_sine(f: f64, x: f64, sign: f64) -> Derivatives {
    let square = 1.0 / ((1.0 - x) * (1.0 + x));
    let slope = sign * square.sqrt();
    let third = (1.0 + 2.0 * x * x) * square * square;
    [f, slope, x * square * slope, third * slope]
}

/// σ′, σ″ and σ‴ of the logistic function σ at x.
fn slopes_of_logistic(logistic: f64, x: f64) -> [f64; 3] {
    let slope = logistic * Unary::Logistic.value(-x);
    // 1 − 2 σ(x).
    let difference = -libm::tanh(x / 2.0);
    [slope, slope * difference, slope * (1.0 - 6.0 * slope)]
}

fn hyperbolic_tangent(f: f64, x: f64) -> Derivatives {
    // 1 − f², without its cancellation.
    let cosh = libm::cosh(x);
    let slope = 1.0 / (cosh * cosh);
    [f, slope, -2.0 * f * slope, (6.0 * f * f - 2.0) * slope]
}

fn hyperbolic_secant(f: f64, tanh: f64) -> Derivatives {
    let second = f * (1.0 - 2.0 * f * f);
    [f, -f * tanh, second, f * tanh * (6.0 * f * f - 1.0)]
}

fn inverse_hyperbolic_cosine(f: f64, x: f64) -> Derivatives {
    // x² may overflow where the slope does not vanish.
    let slope = 1.0 / ((x - 1.0).sqrt() * (x + 1.0).sqrt());
    let (square, ratio) = (slope * slope, x * slope);
    let third = (2.0 * ratio * ratio + square) * square * slope;
    [f, slope, -ratio * square, third]
}

/// f, f′, f″ and f‴ of the elementary functions: Abramowitz and Stegun, Handbook of Mathematical
/// Functions (1964), 4.3, 4.4, 4.5 and 4.6.
pub(super) fn derivatives(function: Unary, x: f64) -> Derivatives {
    let f = function.value(x);
    match function {
        Unary::Sin => alternating(f, libm::cos(x)),
        Unary::Cos => alternating(f, -libm::sin(x)),
        Unary::Tan => {
            let slope = 1.0 + f * f;
            [f, slope, 2.0 * f * slope, (2.0 + 6.0 * f * f) * slope]
        }
        Unary::Asin => inverse_sine(f, x, 1.0),
        Unary::Acos => inverse_sine(f, x, -1.0),
        Unary::Atan => {
            let (cos, sin) = unit_circle(x);
            let slope = cos * cos;
            let third = (6.0 * sin * sin - 2.0 * slope) * slope * slope;
            [f, slope, -2.0 * sin * cos * slope, third]
        }
        Unary::Sinh => repeating(f, libm::cosh(x)),
        Unary::Cosh => repeating(f, libm::sinh(x)),
        Unary::Tanh => hyperbolic_tangent(f, x),
        Unary::Sech => hyperbolic_secant(f, libm::tanh(x)),
        Unary::Asinh => {
            let (slope, sin) = unit_circle(x);
            let square = slope * slope;
            let third = (2.0 * sin * sin - square) * square * slope;
            [f, slope, -sin * square, third]
        }
        Unary::Acosh => inverse_hyperbolic_cosine(f, x),
        Unary::Atanh => {
            let slope = 1.0 / ((1.0 - x) * (1.0 + x));
            let third = (2.0 + 6.0 * x * x) * slope * slope * slope;
            [f, slope, 2.0 * x * slope * slope, third]
        }
        Unary::Exp => [f, f, f, f],
        Unary::Ln => {
            let slope = 1.0 / x;
            [f, slope, -slope * slope, 2.0 * slope * slope * slope]
        }
        Unary::LogCosh => {
            let (tanh, sech) = (libm::tanh(x), Unary::Sech.value(x));
            [f, tanh, sech * sech, -2.0 * tanh * sech * sech]
        }
        Unary::Logistic => {
            let [slope, second, third] = slopes_of_logistic(f, x);
            [f, slope, second, third]
        }
        Unary::Softplus => {
            let logistic = Unary::Logistic.value(x);
            let [slope, second, _] = slopes_of_logistic(logistic, x);
            [f, logistic, slope, second]
        }
        Unary::Abs => [f, Unary::Signum.value(x), 0.0, 0.0],
        Unary::Signum => [f, 0.0, 0.0, 0.0],
    }
}

/// The point (1, x) on the unit circle, of which the squares do not overflow.
fn unit_circle(x: f64) -> (f64, f64) {
    let radius = libm::hypot(1.0, x);
    (1.0 / radius, x / radius)
}
