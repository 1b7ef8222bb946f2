//! Binary64 with a bound on its own error.

use lagrangian_symbolic::{Binary, Rational, Unary};

use crate::Number;

/// A value, and how far it can be from that of exact arithmetic. The bound is infinite where a
/// function has a jump, a pole or the end of its domain within reach.
#[derive(Clone, Copy, Debug)]
pub struct Bounded {
    pub value: f64,
    pub error: f64,
}

impl Bounded {
    pub fn exact(value: f64) -> Self {
        Self { value, error: 0.0 }
    }

    /// A value that was rounded `ulps` times at most.
    fn rounded(value: f64, error: f64, ulps: f64) -> Self {
        // The smallest number stands for what is lost to underflow.
        let error = error + ulps * (f64::EPSILON * value.abs() + f64::MIN_POSITIVE);
        let error = if error.is_nan() { f64::INFINITY } else { error };
        Self { value, error }
    }

    /// f of this, for an f that is monotonic or even within the bound.
    fn through(self, f: impl Fn(f64) -> f64) -> Self {
        let value = f(self.value);
        if !self.error.is_finite() {
            // It may have no value, as a quotient by what may be zero: then nothing of it has one.
            return Self::unbounded(value);
        }
        let error = [self.value - self.error, self.value + self.error]
            .map(|end| (f(end) - value).abs())
            .into_iter()
            .fold(0.0, worst);
        Self::rounded(value, error, 4.0)
    }

    pub fn includes_zero(self) -> bool {
        self.value.abs() <= self.error
    }

    fn unbounded(value: f64) -> Self {
        Self {
            value,
            error: f64::INFINITY,
        }
    }

    pub fn is_reliable(self) -> bool {
        self.value.is_finite() && self.error.is_finite()
    }

    /// Whether both can be the same number.
    pub fn agrees(self, other: Self) -> bool {
        let difference = (self.value - other.value).abs();
        difference <= self.error + other.error
    }
}

/// The greater of two, NaN winning as infinity.
fn worst(a: f64, b: f64) -> f64 {
    if a.is_nan() || b.is_nan() {
        f64::INFINITY
    } else {
        a.max(b)
    }
}

impl Number for Bounded {
    fn rational(value: &Rational) -> Self {
        Self::rounded(value.to_f64(), 0.0, if value.is_zero() { 0.0 } else { 1.0 })
    }

    fn pi() -> Self {
        Self::rounded(core::f64::consts::PI, 0.0, 1.0)
    }

    fn add(self, other: Self) -> Self {
        Self::rounded(self.value + other.value, self.error + other.error, 1.0)
    }

    fn multiply(self, other: Self) -> Self {
        let error = |a: Self, b: Self| {
            if b.error == 0.0 {
                0.0
            } else {
                a.value.abs() * b.error
            }
        };
        let both = error(self, other) + error(other, self) + self.error * other.error;
        Self::rounded(self.value * other.value, both, 1.0)
    }

    fn power(self, exponent: &Rational) -> Self {
        let whole = exponent.to_integer().and_then(|k| i32::try_from(k).ok());
        if exponent.is_negative() && self.includes_zero() {
            return Self::unbounded(self.value.powf(exponent.to_f64()));
        }
        let mut result = match whole {
            Some(k) => self.through(|x| x.powi(k)),
            None => self.through(|x| x.powf(exponent.to_f64())),
        };
        if let Some(k) = whole {
            // Repeated multiplication rounds as often.
            result.error += f64::from(k.abs()) * f64::EPSILON * result.value.abs();
        } else {
            // The exponent was rounded.
            result.error += (result.value * self.value.ln()).abs() * f64::EPSILON;
            result.error = worst(result.error, 0.0);
        }
        result
    }

    fn unary(self, function: Unary) -> Self {
        let f = |x| function.value(x);
        match function {
            Unary::Sin | Unary::Cos | Unary::Abs => Self::rounded(f(self.value), self.error, 2.0),
            Unary::Signum if self.error > 0.0 && self.includes_zero() => {
                Self::unbounded(f(self.value))
            }
            Unary::Signum => Self::exact(f(self.value)),
            // The slope of tan is 1 + tan², and grows within the bound near a pole.
            Unary::Tan if self.error * (1.0 + f(self.value).powi(2)) > 0.1 => {
                Self::unbounded(f(self.value))
            }
            _ => self.through(f),
        }
    }

    fn binary(self, function: Binary, other: Self) -> Self {
        let value = function.value(self.value, other.value);
        match function {
            Binary::Min | Binary::Max => {
                if self.value.is_nan() || other.value.is_nan() {
                    return Self::unbounded(f64::NAN);
                }
                Self::rounded(value, self.error.max(other.error), 1.0)
            }
            // The cut along the negative axis, and the origin.
            Binary::Atan2 if self.includes_zero() && other.value <= other.error => {
                Self::unbounded(value)
            }
            Binary::Power if self.includes_zero() => Self::unbounded(value),
            // A power of two by which products are divided again.
            Binary::Scale => Self::exact(value),
            Binary::Atan2 | Binary::Power => {
                let ends = |x: Self| [x.value - x.error, x.value + x.error];
                let mut error = 0.0;
                for x in ends(self) {
                    for y in ends(other) {
                        error = worst(error, (function.value(x, y) - value).abs());
                    }
                }
                Self::rounded(value, error, 4.0)
            }
        }
    }
}
