//! The arithmetics in which a tape is evaluated.

use crate::validation::hyper_dual::{HyperDual, real_power};
use crate::{Binary, Unary};

/// Numbers on which a tape is evaluated.
pub(crate) trait Number: Copy {
    const ZERO: Self;
    fn constant(value: f64) -> Self;
    fn value(self) -> f64;
    fn add(self, y: Self) -> Self;
    fn subtract(self, y: Self) -> Self;
    fn multiply(self, y: Self) -> Self;
    fn divide(self, y: Self) -> Self;
    fn scaled(self, factor: f64) -> Self;
    /// A number to which all parts are moved that much.
    fn shifted(self, distance: f64) -> Self;
    fn power(self, k: f64) -> Self;
    fn unary(self, function: Unary) -> Self;
    fn binary(self, function: Binary, y: Self) -> Self;
    fn composed(value: f64, slopes: &[Self], arguments: &[Self]) -> Self;
}

impl Number for f64 {
    const ZERO: Self = 0.0;

    fn constant(value: f64) -> Self {
        value
    }

    fn value(self) -> f64 {
        self
    }

    fn add(self, y: Self) -> Self {
        self + y
    }

    fn subtract(self, y: Self) -> Self {
        self - y
    }

    fn multiply(self, y: Self) -> Self {
        self * y
    }

    fn divide(self, y: Self) -> Self {
        self / y
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

impl Number for HyperDual {
    const ZERO: Self = Self::constant(0.0);

    fn constant(value: f64) -> Self {
        Self::constant(value)
    }

    fn value(self) -> f64 {
        self.value
    }

    fn add(self, y: Self) -> Self {
        self + y
    }

    fn subtract(self, y: Self) -> Self {
        self - y
    }

    fn multiply(self, y: Self) -> Self {
        self * y
    }

    fn divide(self, y: Self) -> Self {
        self * y.reciprocal()
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

    fn scaled(self, factor: f64) -> Self {
        Self::scaled(self, factor)
    }

    fn power(self, k: f64) -> Self {
        Self::power(self, k)
    }

    fn unary(self, function: Unary) -> Self {
        Self::unary(self, function)
    }

    fn binary(self, function: Binary, y: Self) -> Self {
        Self::binary(self, function, y)
    }

    fn composed(value: f64, slopes: &[Self], arguments: &[Self]) -> Self {
        Self::composed(value, slopes, arguments)
    }
}
