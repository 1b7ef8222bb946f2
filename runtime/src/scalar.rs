//! Scalars: the numbers on which a model can be evaluated.
//!
//! Emitted code is generic over [`Scalar`] and straight-line. Control flow (a pivot that
//! vanishes, a step that is too long) is in this crate, and reads a scalar only by
//! [`Scalar::smallest`], [`Scalar::largest`] and [`Scalar::in_lane`], so that SIMD lanes and dual numbers are possible.

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

/// A real number, or several at once: `f64`, `f32`, a dual number, a double-double, SIMD lanes. The
/// implementations are listed [below](#scalars).
///
/// Implement it for a type of your own to evaluate every derived model on it. The elementary
/// functions are those of the declaration language; angles are in radians. Lanes do not depend on each
/// other: a lane has the result that it has alone. Only rounding errors differ, where M is factored numerically
/// and that of another lane is not positive definite.
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
/// A type of your own is `Copy`, `Debug` and `PartialEq`, from which `nalgebra::Scalar` follows; it has the
/// operators `+ - * /`, `+= -= *= /=` and the minus sign, and
/// [`Zero`](crate::num_traits::Zero) and [`One`](crate::num_traits::One), which this crate re-exports.
///
/// Parameters are of the scalar type, too, in a `struct Oscillator<T: Scalar> { m: T, k: T }`.
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
/// Dual numbers differentiate with respect to whatever has a derivative part: a parameter, an initial
/// value, the time, an input. An integration on dual numbers differentiates its steps; adaptive methods choose their
/// sizes by the derivative parts, too. The derivatives by all initial values at once are a
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
    /// The scalar nearest to `value`, in every lane, with no derivative part.
    fn from_f64(value: f64) -> Self;

    /// The quotient of two numbers, in every lane: how a constant that `f64` cannot represent, such as the
    /// 0.1 of a declaration, is converted. A scalar of more digits than `f64` divides in its own arithmetic.
    #[inline]
    #[must_use]
    fn ratio(numerator: f64, denominator: f64) -> Self {
        Self::from_f64(numerator / denominator)
    }

    /// π, with all digits of the scalar.
    #[inline]
    #[must_use]
    fn pi() -> Self {
        Self::from_f64(core::f64::consts::PI)
    }

    /// The smallest positive normal number: added to a root, it changes nothing but 0.
    ///
    /// Emitted code adds it where it divides by a root and the quotient has a limit. The default, that of `f32`,
    /// serves every format of at least that range, unless digits are needed below 10⁻³⁰ or so.
    #[inline]
    #[must_use]
    fn min_positive() -> Self {
        Self::from_f64(f32::MIN_POSITIVE.into())
    }

    /// The value of a plain number; the smallest over the lanes of several, NaN if one of them is.
    fn smallest(self) -> f64;

    /// The value of a plain number; the largest over the lanes of several, NaN if one of them is.
    fn largest(self) -> f64;

    /// The value in a lane; that of a plain number whatever the lane.
    #[inline]
    fn in_lane(self, lane: usize) -> f64 {
        let _ = lane;
        self.largest()
    }

    /// How many derivative parts the number has.
    const DERIVATIVES: usize = 0;

    /// A derivative part; 0 for a number that does not have as many. With it, adaptive steps see derivatives where the
    /// values rest.
    #[inline]
    fn derivative_part(self, index: usize) -> f64 {
        let _ = index;
        0.0
    }

    /// The distance from 1 to the next larger number, by which rounding errors are estimated.
    #[must_use]
    fn machine_epsilon() -> f64 {
        // The machine epsilon of a double-double is about 2⁻¹⁰⁴; the bound ends the loop for exact arithmetic.
        let halvings = (0..110).take_while(|&n| {
            let half = Self::from_f64(libm::ldexp(0.5, -n));
            ((Self::one() + half) - Self::one()).largest() > 0.0
        });
        halvings.fold(1.0, |epsilon, _| epsilon / 2.0)
    }

    /// Whether the value is finite in every lane.
    #[inline]
    fn is_finite(self) -> bool {
        self.smallest().is_finite() && self.largest().is_finite()
    }

    /// The number in lanes where `mask` is 1, and 0 in those where it is 0, also if the number is not finite there.
    ///
    /// By the default, `min` and `max` ignore a NaN: they bound the number by 0/0 where the mask is 1, and by 0 where it is 0. Dual
    /// numbers of lanes mask their derivative parts, too.
    #[inline]
    #[must_use]
    fn masked(self, mask: Self) -> Self {
        let bound = Self::zero() / (Self::one() - mask);
        self.max(bound).min(bound)
    }

    /// `self · factor + summand`, fused only where the target has the instruction.
    #[inline]
    #[must_use]
    fn mul_add(self, factor: Self, summand: Self) -> Self {
        self * factor + summand
    }

    /// Sine and cosine of the same angle.
    #[inline]
    #[must_use]
    fn sin_cos(self) -> (Self, Self) {
        (self.sin(), self.cos())
    }

    /// Sines and cosines of several angles, each as [`sin_cos`](Self::sin_cos) gives them.
    ///
    /// Emitted code calls it for the angles of all coordinates at once; override it for a type that computes several
    /// angles faster together than one by one.
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
    /// 1/cosh, the hyperbolic secant, with all digits where it is small.
    #[inline]
    #[must_use]
    fn sech(self) -> Self {
        Self::one() / self.cosh()
    }
    /// The logistic function 1/(1 + e⁻ˣ), with all digits where it is small.
    ///
    /// Quotients and logarithms of sums of exponentials are evaluated by it, by [`softplus`](Self::softplus),
    /// [`log_cosh`](Self::log_cosh) and [`sech`](Self::sech), which do not overflow. All have a default; dual numbers of your own implement them for derivative
    /// parts where e⁻ˣ overflows, and for those of `softplus` at 0.
    #[inline]
    #[must_use]
    fn logistic(self) -> Self {
        Self::one() / (Self::one() + (-self).exp())
    }
    /// ln(1 + eˣ), with all digits where it is small.
    #[inline]
    #[must_use]
    fn softplus(self) -> Self {
        // ln(1 + e) = 2 artanh(e/(2 + e)) for e = exp(−|x|).
        let small = (-self.abs()).exp();
        let half = (small / (Self::one() + Self::one() + small)).atanh();
        self.max(Self::zero()) + half + half
    }
    /// ln cosh x, with all digits where it is small.
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
    /// The square root. The derivative parts of a root of 0 are those of a sum of squares: where those of the
    /// radicand are 0, so are those of the root.
    #[must_use]
    fn sqrt(self) -> Self;
    /// `self` to a real power; NaN where real numbers have none.
    #[must_use]
    fn powf(self, exponent: Self) -> Self;
    /// The absolute value.
    #[must_use]
    fn abs(self) -> Self;
    /// −1, 0 or 1. Unlike [`f64::signum`], it is 0 at 0, where |x| has no derivative.
    #[must_use]
    fn signum(self) -> Self;
    /// The largest whole number that is not greater, without derivative parts.
    ///
    /// Found digit by digit; lanes for which the processor has something better implement it.
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
    /// Emitted code multiplies both by it where it squares them, so that the squares neither underflow nor overflow. It takes
    /// them in either order, in which the scale is the same.
    /// The default is 1, with which slopes of `atan2` have their digits at distances whose squares are
    /// representable.
    #[inline]
    #[must_use]
    fn common_scale(self, other: Self) -> Self {
        let _ = other;
        Self::one()
    }
    /// The lesser of two numbers; in lanes, the other one where one of them is NaN.
    #[must_use]
    fn min(self, other: Self) -> Self;
    /// The greater of two numbers; in lanes, the other one where one of them is NaN.
    #[must_use]
    fn max(self, other: Self) -> Self;
    /// `self` to a whole power, by repeated squares.
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
    /// The nearest number between two limits, of which `least` is not above `most`: the saturation of an actuator. NaN stays NaN,
    /// but in lanes, where it becomes `least`.
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
    /// An angle in degrees, in radians.
    #[inline]
    #[must_use]
    fn to_radians(self) -> Self {
        self * (Self::pi() / Self::from_f64(180.0))
    }
    /// An angle in radians, in degrees.
    #[inline]
    #[must_use]
    fn to_degrees(self) -> Self {
        self * (Self::from_f64(180.0) / Self::pi())
    }
}

#[cfg(test)]
mod tests {
    use super::Scalar;

    /// A number that leaves the machine epsilon to the trait.
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
