//! Sums, products and differences of rationals, on machine integers where both are small.

use super::{Fraction, Rational};

impl core::ops::Add for &Rational {
    type Output = Rational;

    fn add(self, other: Self) -> Rational {
        match (&self.0, &other.0) {
            // Nearly all are integers, whose sums have nothing to reduce.
            (Fraction::Small(a, 1), Fraction::Small(c, 1)) => match a.checked_add(*c) {
                Some(sum) => Rational(Fraction::Small(sum, 1)),
                None => Rational::from_wide(i128::from(*a) + i128::from(*c), 1),
            },
            (Fraction::Small(a, b), Fraction::Small(c, d)) => {
                let (a, b) = (i128::from(*a), i128::from(*b));
                let (c, d) = (i128::from(*c), i128::from(*d));
                Rational::from_wide(a * d + c * b, b * d)
            }
            _ => Rational::from_big(self.to_big() + other.to_big()),
        }
    }
}

impl core::ops::Mul for &Rational {
    type Output = Rational;

    fn mul(self, other: Self) -> Rational {
        match (&self.0, &other.0) {
            (Fraction::Small(1, 1), _) => other.clone(),
            (_, Fraction::Small(1, 1)) => self.clone(),
            (Fraction::Small(-1, 1), _) => -other,
            (_, Fraction::Small(-1, 1)) => -self,
            (Fraction::Small(a, 1), Fraction::Small(c, 1)) => match a.checked_mul(*c) {
                Some(product) => Rational(Fraction::Small(product, 1)),
                None => Rational::from_wide(i128::from(*a) * i128::from(*c), 1),
            },
            (Fraction::Small(a, b), Fraction::Small(c, d)) => Rational::from_wide(
                i128::from(*a) * i128::from(*c),
                i128::from(*b) * i128::from(*d),
            ),
            _ => Rational::from_big(self.to_big() * other.to_big()),
        }
    }
}

impl core::ops::Neg for &Rational {
    type Output = Rational;

    fn neg(self) -> Rational {
        match &self.0 {
            Fraction::Small(numerator, denominator) if *numerator != i64::MIN => {
                Rational(Fraction::Small(-numerator, *denominator))
            }
            _ => Rational::from_big(-self.to_big()),
        }
    }
}

impl core::ops::Sub for &Rational {
    type Output = Rational;

    fn sub(self, other: Self) -> Rational {
        self + &-other
    }
}
