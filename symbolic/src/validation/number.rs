//! The arithmetics in which a tape is evaluated.

use core::ops::{Add, Div, Mul, Sub};

use crate::{Binary, Unary};

/// Numbers on which a tape is evaluated.
pub(crate) trait Number:
    Copy + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + Div<Output = Self>
{
    fn constant(value: f64) -> Self;
    fn value(self) -> f64;
    /// All parts times a number.
    fn scaled(self, factor: f64) -> Self;
    /// A number to which all parts are moved that much.
    fn shifted(self, distance: f64) -> Self;
    fn power(self, k: f64) -> Self;
    fn unary(self, function: Unary) -> Self;
    fn binary(self, function: Binary, y: Self) -> Self;
    /// A function of which the value and the partial derivatives are known, at the arguments.
    fn composed(value: f64, slopes: &[Self], arguments: &[Self]) -> Self;
}

impl Number for f64 {
    fn constant(value: f64) -> Self {
        value
    }

    fn value(self) -> f64 {
        self
    }

    fn scaled(self, factor: f64) -> Self {
        self * factor
    }

    fn shifted(self, distance: f64) -> Self {
        self + distance
    }

    fn power(self, k: f64) -> Self {
        real_power(self, k)
    }

    fn unary(self, function: Unary) -> Self {
        function.value(self)
    }

    fn binary(self, function: Binary, y: Self) -> Self {
        function.value(self, y)
    }

    fn composed(value: f64, _: &[Self], _: &[Self]) -> Self {
        value
    }
}

/// xᵏ, for the powers that occur most without a general power.
#[allow(clippy::float_cmp)] // Exact exponents.
pub(super) fn real_power(x: f64, k: f64) -> f64 {
    if k == 0.5 {
        return x.sqrt();
    }
    if k == 2.0 {
        return x * x;
    }
    if k == -1.0 {
        return 1.0 / x;
    }
    if k == -0.5 {
        return 1.0 / x.sqrt();
    }
    libm::pow(x, k)
}
