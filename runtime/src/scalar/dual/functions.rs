//! The functions of dual numbers: f(x + x′ε) = f(x) + f′(x) x′ε.
//!
//! The derivatives f′ are from Abramowitz and Stegun, *Handbook of Mathematical Functions*, 1964, chapter 4, in forms
//! that are accurate wherever f′ is representable.

use core::array::from_fn;

use super::Dual;
use crate::scalar::Scalar;

impl<S: Scalar, const N: usize> Dual<S, N> {
    /// Returns f(self), given f and f′ at the value.
    #[inline]
    fn chain(self, value: S, slope: S) -> Self {
        Self {
            value,
            derivative: self.derivative.map(|own| own * slope),
        }
    }

    /// Returns f(self), given f and 1/f′ at the value.
    #[inline]
    fn chain_over(self, value: S, divisor: S) -> Self {
        Self {
            value,
            derivative: self.derivative.map(|own| own / divisor),
        }
    }

    /// Returns f(self, other), given f and both partial derivatives at the values.
    #[inline]
    fn chain_of_two(self, other: Self, value: S, [first, second]: [S; 2]) -> Self {
        let slope = |k: usize| self.derivative[k].mul_add(first, other.derivative[k] * second);
        Self {
            value,
            derivative: from_fn(slope),
        }
    }

    /// Returns the lesser or the greater of two numbers, given the share of the first: 1, 0, or ½ if they are equal.
    #[inline]
    fn mean(self, other: Self, value: S, share: S) -> Self {
        let derivative = if share.smallest() >= 1.0 {
            self.derivative
        } else if share.largest() <= 0.0 {
            other.derivative
        } else {
            let part = |slope: S, share: S| slope.masked(share.signum()) * share;
            let rest = S::one() - share;
            from_fn(|k| part(self.derivative[k], share) + part(other.derivative[k], rest))
        };
        Self { value, derivative }
    }
}

/// Returns the share of the first of two numbers in the greater one; 1 where one of them is NaN, which `min` ignores.
#[inline]
fn share_of_first<S: Scalar>(first: S, second: S) -> S {
    let sign = (first - second).signum().min(S::one());
    S::from_f64(0.5) * (S::one() + sign)
}

/// Replaces a divisor that is 0 at the end of a function's domain, where the slope is infinite, by the smallest number,
/// so that an argument without a derivative has a result without one.
#[inline]
fn above_zero<S: Scalar>(divisor: S) -> S {
    divisor + S::min_positive()
}

/// Returns the slopes of the angle of a point (x, y): x/(x² + y²) by y and −y/(x² + y²) by x.
///
/// Both coordinates are scaled by a power of two, so that their squares neither underflow nor overflow (R. L. Smith,
/// *Algorithm 116: complex division*, Comm. ACM **5** (1962) 435).
#[inline]
fn angle_slopes<S: Scalar>(y: S, x: S) -> [S; 2] {
    let scale = y.common_scale(x);
    let (sine, cosine) = (y * scale, x * scale);
    let square = sine * sine + cosine * cosine;
    [cosine / square * scale, -sine / square * scale]
}

/// Returns 1 where a number is 0, and 0 elsewhere.
#[inline]
fn guard<S: Scalar>(x: S) -> S {
    S::one() - x.signum() * x.signum()
}

/// Returns (1 − x)(1 + x), an accurate form of 1 − x² near ±1.
#[inline]
fn unit_difference<S: Scalar>(x: S) -> S {
    (S::one() - x) * (S::one() + x)
}

impl<S: Scalar, const N: usize> Scalar for Dual<S, N> {
    /// The derivative parts of the value, if it is a dual number, too; then each derivative with its own parts.
    const DERIVATIVES: usize = S::DERIVATIVES + N * (1 + S::DERIVATIVES);

    /// Returns the part with the largest magnitude over all lanes.
    #[inline]
    fn derivative_part(self, index: usize) -> f64 {
        let Some(beyond) = index.checked_sub(S::DERIVATIVES) else {
            return self.value.derivative_part(index);
        };
        let width = 1 + S::DERIVATIVES;
        let Some(derivative) = self.derivative.get(beyond / width) else {
            return 0.0;
        };
        match (beyond % width).checked_sub(1) {
            Some(part) => derivative.derivative_part(part),
            None => largest_magnitude(*derivative),
        }
    }

    #[inline]
    fn from_f64(value: f64) -> Self {
        Self::constant(S::from_f64(value))
    }

    #[inline]
    fn ratio(numerator: f64, denominator: f64) -> Self {
        Self::constant(S::ratio(numerator, denominator))
    }

    #[inline]
    fn pi() -> Self {
        Self::constant(S::pi())
    }

    #[inline]
    fn min_positive() -> Self {
        Self::constant(S::min_positive())
    }

    #[inline]
    fn smallest(self) -> f64 {
        self.value.smallest()
    }

    #[inline]
    fn largest(self) -> f64 {
        self.value.largest()
    }

    #[inline]
    fn in_lane(self, lane: usize) -> f64 {
        self.value.in_lane(lane)
    }

    #[inline]
    fn machine_epsilon() -> f64 {
        S::machine_epsilon()
    }

    #[inline]
    fn masked(self, mask: Self) -> Self {
        Self {
            value: self.value.masked(mask.value),
            derivative: self.derivative.map(|slope| slope.masked(mask.value)),
        }
    }

    #[inline]
    fn mul_add(self, factor: Self, summand: Self) -> Self {
        let slope = |k: usize| {
            let rest = self
                .value
                .mul_add(factor.derivative[k], summand.derivative[k]);
            self.derivative[k].mul_add(factor.value, rest)
        };
        Self {
            value: self.value.mul_add(factor.value, summand.value),
            derivative: from_fn(slope),
        }
    }

    #[inline]
    fn sin_cos(self) -> (Self, Self) {
        let (sine, cosine) = self.value.sin_cos();
        (self.chain(sine, cosine), self.chain(cosine, -sine))
    }

    #[inline]
    fn sines_and_cosines<const K: usize>(angles: [Self; K]) -> ([Self; K], [Self; K]) {
        let (sines, cosines) = S::sines_and_cosines(angles.map(|angle| angle.value));
        (
            from_fn(|i| angles[i].chain(sines[i], cosines[i])),
            from_fn(|i| angles[i].chain(cosines[i], -sines[i])),
        )
    }

    #[inline]
    fn sin(self) -> Self {
        self.sin_cos().0
    }

    #[inline]
    fn cos(self) -> Self {
        self.sin_cos().1
    }

    #[inline]
    fn tan(self) -> Self {
        let tangent = self.value.tan();
        self.chain(tangent, S::one() + tangent * tangent)
    }

    #[inline]
    fn asin(self) -> Self {
        let root = unit_difference(self.value).sqrt();
        self.chain_over(self.value.asin(), above_zero(root))
    }

    #[inline]
    fn acos(self) -> Self {
        let root = unit_difference(self.value).sqrt();
        self.chain_over(self.value.acos(), -above_zero(root))
    }

    #[inline]
    fn atan(self) -> Self {
        let [slope, _] = angle_slopes(self.value, S::one());
        self.chain(self.value.atan(), slope)
    }

    #[inline]
    fn atan2(self, x: Self) -> Self {
        let slopes = angle_slopes(self.value, x.value);
        self.chain_of_two(x, self.value.atan2(x.value), slopes)
    }

    #[inline]
    fn common_scale(self, other: Self) -> Self {
        Self::constant(self.value.common_scale(other.value))
    }

    #[inline]
    fn sinh(self) -> Self {
        self.chain(self.value.sinh(), self.value.cosh())
    }

    #[inline]
    fn cosh(self) -> Self {
        self.chain(self.value.cosh(), self.value.sinh())
    }

    // 1 − tanh² has no correct digits where it is small.
    #[inline]
    fn tanh(self) -> Self {
        let secant = self.value.sech();
        self.chain(self.value.tanh(), secant * secant)
    }

    // 1/√(1 + x²), with both terms scaled like the slopes of an angle.
    #[inline]
    fn asinh(self) -> Self {
        let scale = S::one().common_scale(self.value);
        let scaled = self.value * scale;
        let root = (scale * scale + scaled * scaled).sqrt();
        self.chain(self.value.asinh(), scale / root)
    }

    #[inline]
    fn acosh(self) -> Self {
        let [below, above] = [self.value - S::one(), self.value + S::one()];
        let root = below.sqrt() * above.sqrt();
        self.chain_over(self.value.acosh(), above_zero(root))
    }

    #[inline]
    fn atanh(self) -> Self {
        let difference = unit_difference(self.value);
        self.chain_over(self.value.atanh(), above_zero(difference))
    }

    #[inline]
    fn exp(self) -> Self {
        let power = self.value.exp();
        self.chain(power, power)
    }

    #[inline]
    fn ln(self) -> Self {
        self.chain_over(self.value.ln(), self.value)
    }

    #[inline]
    fn sech(self) -> Self {
        let secant = self.value.sech();
        self.chain(secant, -(secant * self.value.tanh()))
    }

    #[inline]
    fn logistic(self) -> Self {
        let value = self.value.logistic();
        self.chain(value, value * (-self.value).logistic())
    }

    #[inline]
    fn log_cosh(self) -> Self {
        self.chain(self.value.log_cosh(), self.value.tanh())
    }

    #[inline]
    fn softplus(self) -> Self {
        self.chain(self.value.softplus(), self.value.logistic())
    }

    #[inline]
    fn sqrt(self) -> Self {
        let root = self.value.sqrt();
        self.chain_over(root, above_zero(root + root))
    }

    // xʸ has the slopes y xʸ⁻¹ and xʸ ln x. x⁰ has the slope 0 even at x = 0, where xʸ ln x counts as 0. Where the
    // first slope is infinite, it is about as large as numbers can be.
    #[inline]
    fn powf(self, exponent: Self) -> Self {
        let (x, y) = (self.value, exponent.value);
        let value = x.powf(y);
        let mut power = Self::constant(value);
        if !self.is_constant() {
            let below_one = (S::one() - y).signum().max(S::zero());
            let base = x + guard(x) * below_one * S::min_positive();
            let slope = y * base.powf(y - S::one() + guard(y));
            power.derivative = self.derivative.map(|own| own * slope);
        }
        if !exponent.is_constant() {
            let slope = value * (x + guard(x)).ln();
            power.derivative =
                from_fn(|k| exponent.derivative[k].mul_add(slope, power.derivative[k]));
        }
        power
    }

    #[inline]
    fn abs(self) -> Self {
        self.chain(self.value.abs(), self.value.signum())
    }

    #[inline]
    fn signum(self) -> Self {
        Self::constant(self.value.signum())
    }

    #[inline]
    fn floor(self) -> Self {
        Self::constant(self.value.floor())
    }

    #[inline]
    fn min(self, other: Self) -> Self {
        let share = share_of_first(other.value, self.value);
        self.mean(other, self.value.min(other.value), share)
    }

    #[inline]
    fn max(self, other: Self) -> Self {
        let share = share_of_first(self.value, other.value);
        self.mean(other, self.value.max(other.value), share)
    }
}

/// Returns the number farthest from 0 over all lanes.
#[inline]
fn largest_magnitude<S: Scalar>(x: S) -> f64 {
    let (least, most) = (x.smallest(), x.largest());
    if -least > most { least } else { most }
}
