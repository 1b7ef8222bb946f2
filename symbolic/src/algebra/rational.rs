//! Exact rational numbers of arbitrary precision.
//!
//! Constants stay exact from the literal to the emitted code, where each is rounded once. Nearly all of
//! them are small, so fractions of machine integers stand beside those of `num-rational`.

mod arithmetic;

use core::cmp::Ordering;
use core::fmt;
use core::hash::{Hash, Hasher};

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Signed, ToPrimitive, Zero};

use crate::algebra::hashing::{Mixer, mix};
use crate::limits::{MAX_DECIMAL_EXPONENT, MAX_EXACT_BITS};

/// A rational number in lowest terms.
#[derive(Clone, PartialEq, Eq, Hash)]
pub struct Rational(Fraction);

/// Invariant: lowest terms, positive denominator, and `Small` whenever both parts fit.
#[derive(Clone)]
enum Fraction {
    Small(i64, i64),
    Large(Box<BigRational>),
}

// In lowest terms equal numbers have equal parts. The comparisons and hashes of `num-rational` go
// through continued fractions instead, by a recursion as deep as those are long.
impl PartialEq for Fraction {
    fn eq(&self, other: &Self) -> bool {
        match (self, other) {
            (Self::Small(a, b), Self::Small(c, d)) => a == c && b == d,
            (Self::Large(x), Self::Large(y)) => (x.numer(), x.denom()) == (y.numer(), y.denom()),
            _ => false,
        }
    }
}

impl Eq for Fraction {}

impl Fraction {
    /// A word that depends on all of the number.
    fn code(&self) -> u64 {
        match self {
            Self::Small(numerator, denominator) => {
                mix(numerator.cast_unsigned(), denominator.cast_unsigned())
            }
            Self::Large(value) => {
                let mut mixer = Mixer::default();
                (value.numer(), value.denom()).hash(&mut mixer);
                mixer.finish()
            }
        }
    }
}

impl Hash for Fraction {
    fn hash<H: Hasher>(&self, state: &mut H) {
        state.write_u64(self.code());
    }
}

impl Rational {
    /// Zero.
    pub const ZERO: Self = Self(Fraction::Small(0, 1));
    /// One.
    pub const ONE: Self = Self(Fraction::Small(1, 1));
    /// Minus one.
    pub const MINUS_ONE: Self = Self(Fraction::Small(-1, 1));
    /// One half.
    pub const HALF: Self = Self(Fraction::Small(1, 2));

    /// The integer `value`.
    #[must_use]
    pub fn integer(value: i64) -> Self {
        Self(Fraction::Small(value, 1))
    }

    /// The fraction `numerator / denominator`, or `None` if the denominator is zero.
    #[must_use]
    pub fn new(numerator: i64, denominator: i64) -> Option<Self> {
        (denominator != 0).then(|| Self::from_wide(i128::from(numerator), i128::from(denominator)))
    }

    /// The value of a decimal literal as Rust writes it: digits, `_`, a point, an exponent.
    ///
    /// ```
    /// use lagrangian_symbolic::Rational;
    ///
    /// assert_eq!(Rational::from_decimal("0.5"), Rational::new(1, 2));
    /// assert_eq!(Rational::from_decimal("6.25e-2"), Rational::new(1, 16));
    /// assert_eq!(Rational::from_decimal("x"), None);
    /// ```
    #[must_use]
    pub fn from_decimal(text: &str) -> Option<Self> {
        let text: String = text.chars().filter(|c| *c != '_').collect();
        let (mantissa, exponent) = match text.split_once(['e', 'E']) {
            Some((mantissa, exponent)) => (mantissa, exponent.parse::<i32>().ok()?),
            None => (text.as_str(), 0),
        };
        let (whole, fraction) = mantissa.split_once('.').unwrap_or((mantissa, ""));
        let digits = format!("{whole}{fraction}");
        if digits.is_empty() || !digits.bytes().all(|digit| digit.is_ascii_digit()) {
            return None;
        }
        let digits: BigInt = digits.parse().ok()?;
        let scale = exponent.checked_sub(i32::try_from(fraction.len()).ok()?)?;
        if scale.unsigned_abs() > MAX_DECIMAL_EXPONENT {
            return None;
        }
        let power = BigInt::from(10).pow(scale.unsigned_abs());
        Some(Self::from_big(if scale < 0 {
            BigRational::new(digits, power)
        } else {
            BigRational::from(digits * power)
        }))
    }

    fn from_wide(numerator: i128, denominator: i128) -> Self {
        let divisor = greatest_common_divisor(numerator.unsigned_abs(), denominator.unsigned_abs());
        // The divisor of two numbers below 2^127 is below it, and is zero for none with d ≠ 0.
        let divisor = i128::try_from(divisor).unwrap_or(1) * denominator.signum();
        let (numerator, denominator) = (numerator / divisor, denominator / divisor);
        match (i64::try_from(numerator), i64::try_from(denominator)) {
            (Ok(numerator), Ok(denominator)) => Self(Fraction::Small(numerator, denominator)),
            _ => Self(Fraction::Large(Box::new(BigRational::new_raw(
                numerator.into(),
                denominator.into(),
            )))),
        }
    }

    fn from_big(value: BigRational) -> Self {
        match (value.numer().to_i64(), value.denom().to_i64()) {
            (Some(numerator), Some(denominator)) => Self(Fraction::Small(numerator, denominator)),
            _ => Self(Fraction::Large(Box::new(value))),
        }
    }

    /// The number as a fraction of integers of any size.
    #[must_use]
    pub fn to_big(&self) -> BigRational {
        match &self.0 {
            Fraction::Small(numerator, denominator) => {
                BigRational::new_raw((*numerator).into(), (*denominator).into())
            }
            Fraction::Large(value) => (**value).clone(),
        }
    }

    /// The nearest binary64; infinite beyond its range.
    #[must_use]
    pub fn to_f64(&self) -> f64 {
        const EXACT: u64 = 1 << 53;
        match &self.0 {
            #[allow(clippy::cast_precision_loss)]
            // Both are exact, so the quotient is rounded once.
            Fraction::Small(numerator, denominator)
                if numerator.unsigned_abs() <= EXACT && denominator.unsigned_abs() <= EXACT =>
            {
                *numerator as f64 / *denominator as f64
            }
            _ => self.to_big().to_f64().unwrap_or(f64::NAN),
        }
    }

    /// The value, if it is an integer that fits.
    #[must_use]
    pub fn to_integer(&self) -> Option<i64> {
        match self.0 {
            Fraction::Small(numerator, 1) => Some(numerator),
            _ => None,
        }
    }

    /// A word that depends on all of the number, for hashes.
    pub(crate) fn code(&self) -> u64 {
        self.0.code()
    }

    /// Whether this is 0.
    #[must_use]
    pub fn is_zero(&self) -> bool {
        matches!(self.0, Fraction::Small(0, 1))
    }

    /// Whether this is 1.
    #[must_use]
    pub fn is_one(&self) -> bool {
        matches!(self.0, Fraction::Small(1, 1))
    }

    /// Whether this is an integer.
    #[must_use]
    pub fn is_integer(&self) -> bool {
        match &self.0 {
            Fraction::Small(_, denominator) => *denominator == 1,
            Fraction::Large(value) => value.is_integer(),
        }
    }

    /// Whether this is an even integer.
    #[must_use]
    pub fn is_even(&self) -> bool {
        match &self.0 {
            Fraction::Small(numerator, denominator) => *denominator == 1 && numerator % 2 == 0,
            Fraction::Large(value) => value.is_integer() && !value.numer().bit(0),
        }
    }

    /// Whether this is below 0.
    #[must_use]
    pub fn is_negative(&self) -> bool {
        match &self.0 {
            Fraction::Small(numerator, _) => *numerator < 0,
            Fraction::Large(value) => value.is_negative(),
        }
    }

    /// Whether the number is too long for exact arithmetic on it.
    pub(crate) fn is_long(&self) -> bool {
        match &self.0 {
            Fraction::Small(..) => false,
            Fraction::Large(value) => {
                value.numer().bits().max(value.denom().bits()) > MAX_EXACT_BITS
            }
        }
    }

    /// The absolute value.
    #[must_use]
    pub fn abs(&self) -> Self {
        if self.is_negative() {
            -self
        } else {
            self.clone()
        }
    }

    /// The reciprocal, or `None` of zero.
    #[must_use]
    pub fn reciprocal(&self) -> Option<Self> {
        match &self.0 {
            Fraction::Small(0, _) => None,
            Fraction::Small(numerator, denominator) => Some(Self::from_wide(
                i128::from(*denominator),
                i128::from(*numerator),
            )),
            Fraction::Large(value) => Some(Self::from_big(value.recip())),
        }
    }

    /// `self` to an integer power, or `None` for a negative power of zero and for a result too long to
    /// be worth writing out.
    #[must_use]
    pub fn power(&self, exponent: i64) -> Option<Self> {
        if exponent == 0 {
            return Some(Self::ONE);
        }
        if exponent < 0 {
            return self.reciprocal()?.power(exponent.checked_neg()?);
        }
        if exponent == 1 {
            return Some(self.clone());
        }
        if let Some(power) = self.small_power(exponent) {
            return Some(power);
        }
        let value = self.to_big();
        let bits = value.numer().bits().max(value.denom().bits());
        let trivial =
            value.numer().magnitude().is_one() && value.denom().is_one() || self.is_zero();
        if !trivial && bits.checked_mul(exponent.unsigned_abs())? > MAX_EXACT_BITS {
            return None;
        }
        let exponent = if trivial { 2 - exponent % 2 } else { exponent };
        let exponent = u32::try_from(exponent).ok()?;
        Some(Self::from_big(BigRational::new_raw(
            value.numer().pow(exponent),
            value.denom().pow(exponent),
        )))
    }

    /// The power where it is a fraction of machine integers.
    fn small_power(&self, exponent: i64) -> Option<Self> {
        let exponent = u32::try_from(exponent).ok()?;
        let (numerator, denominator) = self.to_fraction()?;
        let powers = (
            numerator.checked_pow(exponent)?,
            denominator.checked_pow(exponent)?,
        );
        Some(Self(Fraction::Small(powers.0, powers.1)))
    }

    /// The exact `degree`-th root of a positive number, if it is rational.
    #[must_use]
    pub fn root(&self, degree: i64) -> Option<Self> {
        let degree = u32::try_from(degree).ok().filter(|degree| *degree > 0)?;
        if self.is_negative() || self.is_zero() {
            return None;
        }
        let value = self.to_big();
        let (numerator, denominator) = (
            value.numer().nth_root(degree),
            value.denom().nth_root(degree),
        );
        let exact =
            numerator.pow(degree) == *value.numer() && denominator.pow(degree) == *value.denom();
        exact.then(|| Self::from_big(BigRational::new_raw(numerator, denominator)))
    }

    /// Numerator and denominator, if both fit in machine integers.
    #[must_use]
    pub fn to_fraction(&self) -> Option<(i64, i64)> {
        match self.0 {
            Fraction::Small(numerator, denominator) => Some((numerator, denominator)),
            Fraction::Large(_) => None,
        }
    }

    /// The largest rational of which both numbers are integer multiples.
    #[must_use]
    pub fn common_divisor(&self, other: &Self) -> Self {
        if let (Fraction::Small(a, b), Fraction::Small(c, d)) = (&self.0, &other.0) {
            let [a, b, c, d] = [*a, *b, *c, *d].map(i128::from);
            let numerator = greatest_common_divisor((a * d).unsigned_abs(), (c * b).unsigned_abs());
            // Both products are at most 2¹²⁶.
            return Self::from_wide(i128::try_from(numerator).unwrap_or(i128::MAX), b * d);
        }
        let (a, b) = (self.to_big(), other.to_big());
        let numerator = big_common_divisor(a.numer() * b.denom(), b.numer() * a.denom());
        Self::from_big(BigRational::new(numerator, a.denom() * b.denom()))
    }
}

fn big_common_divisor(mut a: BigInt, mut b: BigInt) -> BigInt {
    while !b.is_zero() {
        (a, b) = (b.clone(), a % b);
    }
    a.abs()
}

fn greatest_common_divisor(mut a: u128, mut b: u128) -> u128 {
    while b != 0 {
        // Machine words where they suffice: the wide division is a slow call.
        if let (Ok(mut x), Ok(mut y)) = (u64::try_from(a), u64::try_from(b)) {
            while y != 0 {
                (x, y) = (y, x % y);
            }
            return x.into();
        }
        (a, b) = (b, a % b);
    }
    a
}

impl PartialOrd for Rational {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Rational {
    fn cmp(&self, other: &Self) -> Ordering {
        if let (Fraction::Small(a, b), Fraction::Small(c, d)) = (&self.0, &other.0) {
            return (i128::from(*a) * i128::from(*d)).cmp(&(i128::from(*c) * i128::from(*b)));
        }
        let (a, b) = (self.to_big(), other.to_big());
        (a.numer() * b.denom()).cmp(&(b.numer() * a.denom()))
    }
}

impl From<i64> for Rational {
    fn from(value: i64) -> Self {
        Self::integer(value)
    }
}

impl fmt::Display for Rational {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match &self.0 {
            Fraction::Small(numerator, 1) => write!(formatter, "{numerator}"),
            Fraction::Small(numerator, denominator) => {
                write!(formatter, "{numerator}/{denominator}")
            }
            Fraction::Large(value) => write!(formatter, "{value}"),
        }
    }
}

impl fmt::Debug for Rational {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(self, formatter)
    }
}
