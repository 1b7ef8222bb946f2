//! Jets: polynomials of order 3 in a time, truncated (Griewank and Walther, Evaluating Derivatives, 2nd edition 2008,
//! chapter 13).
//!
//! Functions are composed by Faà di Bruno's formula from three derivatives, not by recurrences.

#![allow(clippy::float_cmp)] // Kinks are where arguments are equal.

use core::ops::{Add, Div, Mul, Sub};

use crate::validation::hyper_dual::{Derivatives, derivatives, power_derivatives};
use crate::validation::number::Number;
use crate::{Binary, Unary};

/// The coefficients of order 0 to 3.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(crate) struct Jet(pub(crate) [f64; 4]);

impl Jet {
    /// f of this jet, by the derivatives of f at its value.
    fn lifted(self, [f, first, second, third]: Derivatives) -> Self {
        let [_, a, b, c] = self.0;
        Self([
            f,
            first * a,
            first * b + second * a * a / 2.0,
            first * c + second * a * b + third * a * a * a / 6.0,
        ])
    }

    /// The magnitude of the largest coefficient.
    pub(crate) fn largest(jets: &[Self]) -> f64 {
        let sizes = jets.iter().flat_map(|jet| jet.0).map(f64::abs);
        sizes.fold(0.0, f64::max)
    }

    fn is_constant(self) -> bool {
        self.0[1..].iter().all(|x| *x == 0.0)
    }

    fn zipped(self, y: Self, operation: impl Fn(f64, f64) -> f64) -> Self {
        Self(core::array::from_fn(|k| operation(self.0[k], y.0[k])))
    }
}

impl Number for Jet {
    fn constant(value: f64) -> Self {
        Self([value, 0.0, 0.0, 0.0])
    }

    fn value(self) -> f64 {
        self.0[0]
    }

    fn scaled(self, factor: f64) -> Self {
        Self(self.0.map(|x| x * factor))
    }

    fn shifted(self, distance: f64) -> Self {
        Self(self.0.map(|x| x + distance))
    }

    fn power(self, k: f64) -> Self {
        let size = self.value().abs();
        if !size.is_normal() || !(1.0 / size).is_normal() {
            return self.lifted(power_derivatives(self.value(), k));
        }
        // |x|ᵏ (x/|x|)ᵏ: the fourth power of a large value in the third derivative of 1/x overflows.
        let unit = self.scaled(1.0 / size);
        let power = unit.lifted(power_derivatives(unit.value(), k));
        power.scaled(size.powf(k))
    }

    fn unary(self, function: Unary) -> Self {
        self.lifted(derivatives(function, self.value()))
    }

    fn binary(self, function: Binary, y: Self) -> Self {
        let greater = self.value() > y.value();
        match function {
            Binary::Atan2 => {
                let value = function.value(self.value(), y.value());
                let square = self * self + y * y;
                let slopes = [y / square, (self / square).scaled(-1.0)];
                Self::composed(value, &slopes, &[self, y])
            }
            Binary::Min | Binary::Max if self.value() == y.value() => (self + y).scaled(0.5),
            Binary::Min if greater => y,
            Binary::Max if !greater => y,
            Binary::Min | Binary::Max => self,
            Binary::Scale => Self::constant(function.value(self.value(), y.value())),
            Binary::Power if y.is_constant() => self.power(y.value()),
            Binary::Power => (y * self.unary(Unary::Ln)).unary(Unary::Exp),
        }
    }

    /// Σ fᵢ ẋᵢ, integrated.
    fn composed(value: f64, slopes: &[Self], arguments: &[Self]) -> Self {
        let mut coefficients = [value, 0.0, 0.0, 0.0];
        let orders = [1.0, 2.0, 3.0];
        for (slope, x) in slopes.iter().zip(arguments) {
            for k in 1..4 {
                for i in 1..=k {
                    coefficients[k] += slope.0[k - i] * x.0[i] * orders[i - 1] / orders[k - 1];
                }
            }
        }
        Self(coefficients)
    }
}

impl Add for Jet {
    type Output = Self;

    fn add(self, y: Self) -> Self {
        self.zipped(y, |x, y| x + y)
    }
}

impl Sub for Jet {
    type Output = Self;

    fn sub(self, y: Self) -> Self {
        self.zipped(y, |x, y| x - y)
    }
}

impl Mul for Jet {
    type Output = Self;

    fn mul(self, y: Self) -> Self {
        Self(core::array::from_fn(|k| {
            (0..=k).map(|i| self.0[i] * y.0[k - i]).sum()
        }))
    }
}

impl Div for Jet {
    type Output = Self;

    fn div(self, y: Self) -> Self {
        self * y.power(-1.0)
    }
}
