//! Scalars: the numbers on which a model can be evaluated.
//!
//! Emitted code is generic over [`Scalar`] and has no branches. Control flow, such as the treatment of a vanishing
//! pivot or of a step that is too long, is in this crate, and reads a scalar only by [`Scalar::smallest`],
//! [`Scalar::largest`] and [`Scalar::in_lane`], so that SIMD lanes and dual numbers are possible.

mod arithmetic;
mod double_double;
mod dual;
mod float;
mod lanes;
mod simd;
mod sine_cosine;

use core::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Sub, SubAssign};

use num_traits::{One, Zero};

pub use double_double::DoubleDouble;
pub use dual::Dual;
pub use lanes::Lanes;

/// A real number, or several at once: `f64`, `f32`, a dual number, a double-double, SIMD lanes. The implementations are
/// listed [below](#scalars).
///
/// Implement it for your own type to evaluate every derived model on it. The elementary functions match the declaration
/// language; angles are in radians. Lanes do not depend on each other: each has the result that it would have alone.
/// Only rounding errors differ, if M is factored numerically and is not positive definite in another lane.
///
/// ```
/// use lagrangian::prelude::*;
///
/// #[derive(Lagrangian)]
/// #[lagrangian(coordinates(x), kinetic = 0.5 * m * dot(x).powi(2), potential = 0.5 * k * x.powi(2))]
/// struct Oscillator { m: f64, k: f64 }
///
/// /// The acceleration on any scalar: derivatives with respect to x are propagated to it.
/// fn acceleration<S: Scalar>(x: S) -> S {
///     let state = State::new(S::zero(), [x], [S::zero()]);
///     Oscillator { m: 2.0, k: 3.0 }.accelerations(&state)[Oscillator::X]
/// }
///
/// assert_eq!(acceleration(0.5_f64), -0.75);
/// assert_eq!(acceleration(0.5_f32), -0.75);
/// ```
///
/// Your own type must be `Copy`, `Debug` and `PartialEq`, from which `nalgebra::Scalar` follows. It needs the operators
/// `+ - * /`, `+= -= *= /=` and unary minus, and [`Zero`](num_traits::Zero) and [`One`](num_traits::One),
/// which `lagrangian` re-exports.
///
/// Parameters may have the scalar type, too, as in `struct Oscillator<T: Scalar> { m: T, k: T }`.
///
/// # Scalars
///
/// | type | what it is for | |
/// |---|---|---|
/// | `f64`, `f32` | one number | |
/// | [`Lanes<L>`](Lanes) | `L` numbers at once: parameter studies, ensembles | |
/// | [`DoubleDouble`] | 32 digits: reference values, differences that `f64` rounds away | |
/// | [`Dual<S, N>`](Dual) | the derivatives by `N` quantities, on any scalar `S` | |
/// | `Dual<Dual<S, N>, M>` | second derivatives | |
///
/// Dual numbers differentiate with respect to every quantity that has a derivative part: a parameter, an initial value,
/// the time, an input. An integration on dual numbers differentiates its steps; adaptive methods choose their step
/// sizes by the derivative parts, too. For the derivatives by all initial values at once, see
/// [`StateTransition`](crate::StateTransition). The sensitivity of a motion to a mass and a stiffness:
///
/// ```
/// use lagrangian::Dual;
/// use lagrangian::prelude::*;
///
/// #[derive(Lagrangian)]
/// #[lagrangian(coordinates(x), kinetic = 0.5 * m * dot(x).powi(2), potential = 0.5 * k * x.powi(2))]
/// struct Oscillator<T: Scalar> { m: T, k: T }
///
/// let [m, k] = Dual::variables([2.0, 8.0]);
/// let [zero, one] = [0.0, 1.0].map(Dual::constant);
/// let start = State::new(zero, [one], [zero]);
/// let end = Problem::new(&Oscillator { m, k }, start).solve(1.0, RungeKutta::classical(1e-3))?;
///
/// // x = cos ωt, ω² = k/m = 4; ∂x/∂m = t sin ωt ω/(2 m), ∂x/∂k = −t sin ωt ω/(2 k).
/// let [by_mass, by_stiffness] = end.q[0].derivative;
/// assert!((by_mass - 0.5 * 2.0_f64.sin()).abs() < 1e-9);
/// assert!((by_stiffness + 0.125 * 2.0_f64.sin()).abs() < 1e-9);
/// # Ok::<(), IntegrationError>(())
/// ```
#[diagnostic::on_unimplemented(
    message = "models are not evaluated on `{Self}`",
    note = "write real numbers with a point, such as `0.0`; for a type of your own, implement `Scalar`, the \
            operators, and `Zero` and `One` of `lagrangian::num_traits`"
)]
pub trait Scalar:
    nalgebra::Scalar
    + Copy
    + Zero
    + One
    + Neg<Output = Self>
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + AddAssign
    + SubAssign
    + MulAssign
    + DivAssign
{
    /// Returns the scalar nearest to `value`, in every lane, without derivative parts.
    fn from_f64(value: f64) -> Self;

    /// Returns the quotient of two numbers, in every lane. It represents constants that `f64` cannot, such as the 0.1
    /// of a declaration: a scalar with more digits than `f64` divides in its own arithmetic.
    #[inline]
    #[must_use]
    fn ratio(numerator: f64, denominator: f64) -> Self {
        Self::from_f64(numerator / denominator)
    }

    /// Returns π, with all digits of the scalar.
    #[inline]
    #[must_use]
    fn pi() -> Self {
        Self::from_f64(core::f64::consts::PI)
    }

    /// Returns the smallest positive normal number: added to a root, it changes only 0.
    ///
    /// Emitted code adds it where it divides by a root and the quotient has a limit. The default is the value for
    /// `f32`. It suits every format with at least this range, unless digits are needed below about 10⁻³⁰.
    #[inline]
    #[must_use]
    fn min_positive() -> Self {
        Self::from_f64(f32::MIN_POSITIVE.into())
    }

    /// Returns the value of a plain number, or the smallest over all lanes; NaN if one of them is NaN.
    fn smallest(self) -> f64;

    /// Returns the value of a plain number, or the largest over all lanes; NaN if one of them is NaN.
    fn largest(self) -> f64;

    /// Returns the value in a lane; for a plain number, its value whatever the lane.
    #[inline]
    fn in_lane(self, lane: usize) -> f64 {
        let _ = lane;
        self.largest()
    }

    /// The number of derivative parts.
    const DERIVATIVES: usize = 0;

    /// Returns a derivative part, or 0 beyond their number. With it, adaptive steps see derivatives even where the
    /// values are constant.
    #[inline]
    fn derivative_part(self, index: usize) -> f64 {
        let _ = index;
        0.0
    }

    /// Returns the distance from 1 to the next larger number, by which rounding errors are estimated.
    #[must_use]
    fn machine_epsilon() -> f64 {
        // The machine epsilon of a double-double is about 2⁻¹⁰⁴; the bound ends the loop for exact arithmetic.
        let halvings = (0..110).take_while(|&n| {
            let half = Self::from_f64(libm::ldexp(0.5, -n));
            ((Self::one() + half) - Self::one()).largest() > 0.0
        });
        halvings.fold(1.0, |epsilon, _| epsilon / 2.0)
    }

    /// Returns whether the value is finite in every lane.
    #[inline]
    fn is_finite(self) -> bool {
        self.smallest().is_finite() && self.largest().is_finite()
    }

    /// Returns the number in lanes where `mask` is 1, and 0 in lanes where it is 0, even if the number is not finite
    /// there.
    ///
    /// The default relies on `min` and `max` ignoring a NaN: they bound the number by 0/0 where the mask is 1, and by 0
    /// where it is 0. Dual numbers of lanes mask their derivative parts, too.
    #[inline]
    #[must_use]
    fn masked(self, mask: Self) -> Self {
        let bound = Self::zero() / (Self::one() - mask);
        self.max(bound).min(bound)
    }

    /// Returns `self · factor + summand`, fused only if the target has the instruction.
    #[inline]
    #[must_use]
    fn mul_add(self, factor: Self, summand: Self) -> Self {
        self * factor + summand
    }

    /// Returns the sine and the cosine of an angle.
    #[inline]
    #[must_use]
    fn sin_cos(self) -> (Self, Self) {
        (self.sin(), self.cos())
    }

    /// Returns the sines and cosines of several angles, with the results of [`sin_cos`](Self::sin_cos).
    ///
    /// Emitted code calls it for the angles of all coordinates at once; override it for a type that computes several
    /// angles together faster than one by one.
    #[inline]
    #[must_use]
    fn sines_and_cosines<const K: usize>(angles: [Self; K]) -> ([Self; K], [Self; K]) {
        let pairs = angles.map(Self::sin_cos);
        (pairs.map(|pair| pair.0), pairs.map(|pair| pair.1))
    }

    /// Sine.
    #[must_use]
    fn sin(self) -> Self;
    /// Cosine.
    #[must_use]
    fn cos(self) -> Self;
    /// Tangent.
    #[must_use]
    fn tan(self) -> Self;
    /// Inverse sine.
    #[must_use]
    fn asin(self) -> Self;
    /// Inverse cosine.
    #[must_use]
    fn acos(self) -> Self;
    /// Inverse tangent.
    #[must_use]
    fn atan(self) -> Self;
    /// The angle of the point (`x`, `self`), in (−π, π].
    #[must_use]
    fn atan2(self, x: Self) -> Self;
    /// Hyperbolic sine.
    #[must_use]
    fn sinh(self) -> Self;
    /// Hyperbolic cosine.
    #[must_use]
    fn cosh(self) -> Self;
    /// Hyperbolic tangent.
    #[must_use]
    fn tanh(self) -> Self;
    /// Inverse hyperbolic sine.
    #[must_use]
    fn asinh(self) -> Self;
    /// Inverse hyperbolic cosine.
    #[must_use]
    fn acosh(self) -> Self;
    /// Inverse hyperbolic tangent.
    #[must_use]
    fn atanh(self) -> Self;
    /// The exponential function.
    #[must_use]
    fn exp(self) -> Self;
    /// The natural logarithm.
    #[must_use]
    fn ln(self) -> Self;
    /// 1/cosh, the hyperbolic secant, accurate where it is small.
    #[inline]
    #[must_use]
    fn sech(self) -> Self {
        Self::one() / self.cosh()
    }
    /// The logistic function 1/(1 + e⁻ˣ), accurate where it is small.
    ///
    /// It is used for quotients and logarithms of sums of exponentials, like [`softplus`](Self::softplus),
    /// [`log_cosh`](Self::log_cosh) and [`sech`](Self::sech); none of these overflow. All have defaults; your own dual
    /// numbers implement them for derivative parts where e⁻ˣ overflows, and for the derivative parts of `softplus` at
    /// 0.
    #[inline]
    #[must_use]
    fn logistic(self) -> Self {
        Self::one() / (Self::one() + (-self).exp())
    }
    /// ln(1 + eˣ), accurate where it is small.
    #[inline]
    #[must_use]
    fn softplus(self) -> Self {
        // ln(1 + e) = 2 artanh(e/(2 + e)) for e = exp(−|x|).
        let small = (-self.abs()).exp();
        let half = (small / (Self::one() + Self::one() + small)).atanh();
        self.max(Self::zero()) + half + half
    }
    /// ln cosh x, accurate where it is small.
    #[inline]
    #[must_use]
    fn log_cosh(self) -> Self {
        // |x| + ln(1 + exp(−2|x|)) − ln 2 for |x| > 1, and 2 artanh(tanh² ½x) nearer to 0.
        let two = Self::one() + Self::one();
        let is_far = (self.abs() - Self::one()).signum().max(Self::zero());
        let tangent = (self * (Self::one() - is_far) / two).tanh();
        let near = (tangent * tangent).atanh();
        let far = self.abs() + (-two * self.abs()).softplus() - two.ln();
        is_far * far + near + near
    }
    /// The square root. At 0, its derivative parts are the limits for a sum of squares: 0 if the derivative parts of
    /// the radicand are 0.
    #[must_use]
    fn sqrt(self) -> Self;
    /// `self` to a real power; NaN if it is not real.
    #[must_use]
    fn powf(self, exponent: Self) -> Self;
    /// The absolute value.
    #[must_use]
    fn abs(self) -> Self;
    /// −1, 0 or 1. Unlike [`f64::signum`], it is 0 at 0, where |x| has no derivative.
    #[must_use]
    fn signum(self) -> Self;
    /// The largest integer that is not greater than `self`, without derivative parts.
    ///
    /// The default finds it digit by digit; lanes override it if the processor has a faster instruction.
    #[must_use]
    fn floor(self) -> Self {
        let greater = |x: Self, y: Self| (x - y).signum().max(Self::zero());
        let (least, most) = (self.smallest(), self.largest());
        let mut rest = self.abs();
        let mut whole = Self::zero();
        let highest = libm::ilogb(most.max(-least));
        for digit in (0..=highest).rev() {
            let power = Self::from_f64(libm::ldexp(1.0, digit));
            let part = power * (Self::one() - greater(power, rest));
            rest -= part;
            whole += part;
        }
        let toward_zero = whole * self.signum();
        toward_zero - greater(toward_zero, self)
    }
    /// A power of two, without derivative parts, by which the larger of |self| and |other| becomes about 1.
    ///
    /// Emitted code multiplies both numbers by it before squaring, so that the squares neither underflow nor overflow.
    /// The scale does not depend on the order of the numbers. The default is 1, with which slopes of `atan2` are
    /// accurate at distances whose squares are representable.
    #[inline]
    #[must_use]
    fn common_scale(self, other: Self) -> Self {
        let _ = other;
        Self::one()
    }
    /// The lesser of two numbers; in lanes, the other number if one of them is NaN.
    #[must_use]
    fn min(self, other: Self) -> Self;
    /// The greater of two numbers; in lanes, the other number if one of them is NaN.
    #[must_use]
    fn max(self, other: Self) -> Self;
    /// `self` to an integer power, by repeated squaring.
    #[inline]
    #[must_use]
    fn powi(self, exponent: i32) -> Self {
        let (mut power, mut square) = (Self::one(), self);
        let mut rest = exponent.unsigned_abs();
        while rest > 0 {
            if rest % 2 == 1 {
                power *= square;
            }
            rest /= 2;
            if rest > 0 {
                square *= square;
            }
        }
        if exponent < 0 {
            Self::one() / power
        } else {
            power
        }
    }
    /// The nearest number between two limits with `least` ≤ `most`: the saturation of an actuator. NaN is preserved,
    /// except in lanes, where it becomes `least`.
    #[inline]
    #[must_use]
    fn clamp(self, least: Self, most: Self) -> Self {
        self.max(least).min(most)
    }
    /// √(x² + y²).
    #[inline]
    #[must_use]
    fn hypot(self, other: Self) -> Self {
        let scale = self.common_scale(other);
        let (x, y) = (self * scale, other * scale);
        (x * x + y * y).sqrt() / scale
    }
    /// Converts an angle from degrees to radians.
    #[inline]
    #[must_use]
    fn to_radians(self) -> Self {
        self * (Self::pi() / Self::from_f64(180.0))
    }
    /// Converts an angle from radians to degrees.
    #[inline]
    #[must_use]
    fn to_degrees(self) -> Self {
        self * (Self::from_f64(180.0) / Self::pi())
    }
}

#[cfg(test)]
mod tests {
    use super::Scalar;

    /// Measures the machine epsilon like the default of the trait.
    fn measured<S: Scalar>() -> f64 {
        let halvings = (0..110).take_while(|&n| {
            let half = S::from_f64(libm::ldexp(0.5, -n));
            ((S::one() + half) - S::one()).largest() > 0.0
        });
        halvings.fold(1.0, |epsilon, _| epsilon / 2.0)
    }

    #[test]
    fn machine_epsilon_is_what_addition_shows() {
        assert_eq!(
            f64::machine_epsilon().to_bits(),
            measured::<f64>().to_bits()
        );
        assert_eq!(
            f32::machine_epsilon().to_bits(),
            measured::<f32>().to_bits()
        );
    }
}
