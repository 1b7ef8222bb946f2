//! How exact numbers are written.
//!
//! A number is a fraction or a finite decimal, whichever is shorter: ½ and 9.81, 1/1024 and 0.001.
//! Very large and very small ones carry a power of ten.

use num_bigint::BigInt;
use num_traits::{One, Signed, Zero};

use crate::Rational;
use crate::limits::{MAX_LEADING_ZEROS, ROUND_ZEROS, SMALL_DENOMINATOR};
use crate::print::notation::Notation;

/// The digits of a number that is not negative.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(crate) enum Numeral {
    /// 981 or 9.81.
    Decimal(String),
    /// 6.626 and −34 for 6.626·10⁻³⁴.
    Scientific(String, i64),
    /// 5 and 7 for 5/7.
    Fraction(String, String),
}

impl Numeral {
    /// The digits of |`value`|.
    pub(crate) fn of(value: &Rational) -> Self {
        let value = value.abs().to_big();
        let (numerator, denominator) = (value.numer(), value.denom());
        let Some(decimal) = Self::decimal(numerator.clone(), denominator.clone()) else {
            return Self::Fraction(numerator.to_string(), denominator.to_string());
        };
        if denominator.is_one() {
            return decimal;
        }
        let fraction = Self::Fraction(numerator.to_string(), denominator.to_string());
        let decimal_wins = if *denominator <= SMALL_DENOMINATOR.into() {
            decimal.width() < fraction.width()
        } else {
            decimal.width() <= fraction.width()
        };
        if decimal_wins { decimal } else { fraction }
    }

    /// The finite decimal numerator/denominator, if it is one.
    fn decimal(numerator: BigInt, denominator: BigInt) -> Option<Self> {
        let (digits, places) = decimal_digits(numerator, denominator)?;
        let significant = digits.trim_end_matches('0');
        let zeros = digits.len() - significant.len();
        if places == 0 {
            let round = zeros >= ROUND_ZEROS && !significant.is_empty();
            return Some(if round {
                Self::scientific(significant, zeros.try_into().ok()?)
            } else {
                Self::Decimal(digits)
            });
        }
        if places >= digits.len() + MAX_LEADING_ZEROS {
            return Some(Self::scientific(&digits, -i64::try_from(places).ok()?));
        }
        let padded = format!("{digits:0>width$}", width = places + 1);
        let (whole, fraction) = padded.split_at(padded.len() - places);
        Some(Self::Decimal(format!("{whole}.{fraction}")))
    }

    /// digits·10^exponent with the point behind the first digit.
    fn scientific(digits: &str, exponent: i64) -> Self {
        let (first, rest) = digits.split_at(1);
        let exponent = exponent + i64::try_from(rest.len()).unwrap_or(0);
        let point = if rest.is_empty() { "" } else { "." };
        Self::Scientific(format!("{first}{point}{rest}"), exponent)
    }

    fn width(&self) -> usize {
        match self {
            Self::Decimal(digits) => digits.len(),
            Self::Scientific(digits, exponent) if digits == "1" => 2 + exponent.to_string().len(),
            Self::Scientific(digits, exponent) => digits.len() + 3 + exponent.to_string().len(),
            Self::Fraction(above, below) => above.len() + 1 + below.len(),
        }
    }

    /// Whether the number can carry an exponent without parentheses.
    pub(crate) fn is_plain(&self) -> bool {
        matches!(self, Self::Decimal(_))
    }

    /// The number as it stands alone.
    pub(crate) fn print(&self, notation: Notation) -> String {
        match (self, notation) {
            (Self::Decimal(digits), _) => digits.clone(),
            (Self::Scientific(digits, exponent), _) => {
                let power = format!("10{}", notation.exponent(&exponent.to_string()));
                match (digits.as_str(), notation) {
                    ("1", _) => power,
                    (_, Notation::Unicode) => format!("{digits}×{power}"),
                    (_, Notation::Latex) => format!("{digits} \\times {power}"),
                }
            }
            (Self::Fraction(above, below), Notation::Unicode) => {
                vulgar(above, below).map_or_else(|| format!("{above}/{below}"), String::from)
            }
            (Self::Fraction(above, below), Notation::Latex) => {
                format!("\\frac{{{above}}}{{{below}}}")
            }
        }
    }

    /// The numerator and the denominator of a fraction that, before a product, is written over and under it.
    pub(crate) fn spread(&self, notation: Notation) -> Option<[Self; 2]> {
        match (self, notation) {
            (Self::Fraction(above, below), Notation::Unicode) if vulgar(above, below).is_none() => {
                Some([above, below].map(|digits| Self::Decimal(digits.clone())))
            }
            _ => None,
        }
    }
}

/// The digits of numerator/denominator without a point, and the number of those behind it.
fn decimal_digits(numerator: BigInt, denominator: BigInt) -> Option<(String, usize)> {
    let twos = denominator.trailing_zeros().unwrap_or(0);
    let mut rest = denominator >> twos;
    let mut fives = 0_u64;
    let five = BigInt::from(5);
    while (&rest % &five).is_zero() {
        rest /= &five;
        fives += 1;
    }
    if !rest.abs().is_one() {
        return None;
    }
    let places = twos.max(fives);
    let [more_twos, more_fives] = [places - twos, places - fives].map(u32::try_from);
    let digits = (numerator << more_twos.ok()?) * five.pow(more_fives.ok()?);
    Some((digits.to_string(), usize::try_from(places).ok()?))
}

/// The fractions that have a character of their own.
fn vulgar(above: &str, below: &str) -> Option<&'static str> {
    Some(match (above, below) {
        ("1", "2") => "½",
        ("1", "3") => "⅓",
        ("2", "3") => "⅔",
        ("1", "4") => "¼",
        ("3", "4") => "¾",
        ("1", "5") => "⅕",
        ("2", "5") => "⅖",
        ("3", "5") => "⅗",
        ("4", "5") => "⅘",
        ("1", "6") => "⅙",
        ("5", "6") => "⅚",
        ("1", "8") => "⅛",
        ("3", "8") => "⅜",
        ("5", "8") => "⅝",
        ("7", "8") => "⅞",
        _ => return None,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_written_the_shorter_way() {
        for (literal, unicode) in [
            ("0", "0"),
            ("42", "42"),
            ("0.5", "½"),
            ("0.4", "⅖"),
            ("1.5", "3/2"),
            ("9.81", "9.81"),
            ("9.8", "9.8"),
            ("0.1", "0.1"),
            ("0.001", "0.001"),
            ("0.0009765625", "1/1024"),
            ("12.75", "51/4"),
            ("1000000", "1000000"),
            ("299792458", "299792458"),
            ("5.972e24", "5.972×10²⁴"),
            ("1e30", "10³⁰"),
            ("1e-6", "10⁻⁶"),
            ("1.5e-5", "1.5×10⁻⁵"),
            ("6.62607015e-34", "6.62607015×10⁻³⁴"),
            ("6.674e-11", "6.674×10⁻¹¹"),
        ] {
            let value = Rational::from_decimal(literal).unwrap();
            assert_eq!(Numeral::of(&value).print(Notation::Unicode), unicode);
        }
        let third = Numeral::of(&Rational::new(-5, 7).unwrap());
        assert_eq!(third.print(Notation::Unicode), "5/7");
        assert_eq!(third.print(Notation::Latex), "\\frac{5}{7}");
        let planck = Numeral::of(&Rational::from_decimal("6.6e-34").unwrap());
        assert_eq!(planck.print(Notation::Latex), "6.6 \\times 10^{-34}");
    }
}
