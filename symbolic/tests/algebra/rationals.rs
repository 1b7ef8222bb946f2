//! Exact numbers against `num-rational` and against Rust's own literals.

use std::collections::hash_map::DefaultHasher;
use std::hash::{Hash, Hasher};

use lagrangian_symbolic::Rational;
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Signed, Zero};
use proptest::prelude::*;

/// Machine integers, their ends and small numbers more often than others.
fn integers() -> impl Strategy<Value = i64> {
    prop_oneof![
        3 => -20_i64..=20,
        2 => any::<i64>(),
        1 => prop::sample::select(&[i64::MIN, i64::MIN + 1, i64::MAX, i64::MAX - 1, 1 << 53, (1 << 53) + 1]),
    ]
}

fn fractions() -> impl Strategy<Value = (Rational, BigRational)> {
    (integers(), integers().prop_filter("nonzero", |d| *d != 0)).prop_map(|(n, d)| {
        let exact = BigRational::new(n.into(), d.into());
        (Rational::new(n, d).unwrap(), exact)
    })
}

fn hash(value: &Rational) -> u64 {
    let mut hasher = DefaultHasher::new();
    value.hash(&mut hasher);
    hasher.finish()
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn arithmetic_is_that_of_num_rational((x, a) in fractions(), (y, b) in fractions(), k in -40_i64..40) {
        prop_assert_eq!(x.to_big(), a.clone());
        prop_assert_eq!((&x + &y).to_big(), &a + &b);
        prop_assert_eq!((&x - &y).to_big(), &a - &b);
        prop_assert_eq!((&x * &y).to_big(), &a * &b);
        prop_assert_eq!((-&x).to_big(), -&a);
        prop_assert_eq!(x.abs().to_big(), a.abs());
        prop_assert_eq!(x.cmp(&y), a.cmp(&b));
        prop_assert_eq!(x.reciprocal().map(|x| x.to_big()), (!a.is_zero()).then(|| a.recip()));
        prop_assert_eq!(x.is_negative(), a.is_negative());
        prop_assert_eq!(x.is_integer(), a.is_integer());
        prop_assert_eq!(x.is_even(), a.is_integer() && (a.numer() % 2_i64).is_zero());
        prop_assert_eq!(x.to_string(), a.to_string());
        if let Some(power) = x.power(k) {
            let k = i32::try_from(k).unwrap();
            prop_assert_eq!(power.to_big(), num_traits::Pow::pow(&a, k));
        } else {
            prop_assert!(k < 0 && a.is_zero() || k.abs() > 4096 / 64);
        }
    }

    #[test]
    fn equal_numbers_are_equal_by_every_road((x, _) in fractions(), (y, _) in fractions()) {
        // There and back through numbers that do not fit into machine words.
        let round = &(&(&x + &y) - &y);
        prop_assert_eq!(round, &x);
        prop_assert_eq!(hash(round), hash(&x));
        if let Some(inverse) = y.reciprocal() {
            let round = &(&x * &y) * &inverse;
            prop_assert_eq!(&round, &x);
            prop_assert_eq!(hash(&round), hash(&x));
        }
        // The parts fit exactly where they can.
        let big = x.to_big();
        let fits = |part: &BigInt| i64::try_from(part).is_ok();
        prop_assert_eq!(x.to_fraction().is_some(), fits(big.numer()) && fits(big.denom()));
    }

    #[test]
    fn roots_undo_powers((x, a) in fractions(), degree in 1_i64..6) {
        let size = x.abs();
        prop_assume!(!size.is_zero());
        if let Some(power) = size.power(degree) {
            prop_assert_eq!(power.root(degree), Some(size.clone()));
        }
        if let Some(root) = size.root(degree) {
            prop_assert_eq!(num_traits::Pow::pow(&root.to_big(), i32::try_from(degree).unwrap()), a.abs());
        }
        prop_assert_eq!((-&size).root(degree), None);
    }

    #[test]
    fn common_divisors_divide((x, a) in fractions(), (y, b) in fractions()) {
        prop_assume!(!a.is_zero() && !b.is_zero());
        let divisor = x.common_divisor(&y).to_big();
        let (m, n) = (a / &divisor, b / &divisor);
        prop_assert!(m.is_integer() && n.is_integer() && divisor.is_positive());
        prop_assert!(num_integer_gcd(m.to_integer(), n.to_integer()).is_one());
    }

    #[test]
    fn literals_round_as_in_rust(
        whole in "[0-9]{0,20}", fraction in "[0-9]{0,25}", exponent in prop_oneof![-345_i32..330, -20..20],
    ) {
        let literal = format!("0{whole}.{fraction}e{exponent}");
        let exact = Rational::from_decimal(&literal).unwrap();
        prop_assert_eq!(exact.to_f64().to_bits(), literal.parse::<f64>().unwrap().to_bits(), "{}", literal);
        let halfway = format!("{:?}", f64::from_bits(literal.parse::<f64>().unwrap().to_bits()));
        let exact = Rational::from_decimal(&halfway);
        prop_assert_eq!(exact.map(|x| x.to_f64()), halfway.parse().ok().filter(|x: &f64| x.is_finite()));
    }

    #[test]
    fn quotients_round_once((x, a) in fractions()) {
        // Rust's parser rounds correctly. Ties have denominators that are powers of two, and with 80 digits
        // all of those are exact; a digit more says that something follows.
        let digits = 80;
        let scaled = (a.numer() * BigInt::from(10).pow(digits)) / a.denom();
        let exact = (&a * BigInt::from(10).pow(digits)).is_integer();
        let sticky = if exact { "" } else { "1" };
        let literal = format!("{scaled}{sticky}e-{}", digits as usize + sticky.len());
        prop_assert_eq!(x.to_f64().to_bits(), literal.parse::<f64>().unwrap().to_bits());
    }
}

fn num_integer_gcd(mut a: BigInt, mut b: BigInt) -> BigInt {
    while !b.is_zero() {
        (a, b) = (b.clone(), a % b);
    }
    a.abs()
}

#[test]
fn the_ends_of_binary64_are_reached() {
    for literal in [
        "6.62607015e-34",
        "1e308",
        "1.7976931348623157e308",
        "1.7976931348623158e308",
        "1.797693134862315807e308",
        "1.797693134862315808e308",
        "4.9e-324",
        "2.5e-324",
        "2.4e-324",
        "2.4703282292062327e-324",
        "2.4703282292062328e-324",
        "2.2250738585072011e-308",
        "2.2250738585072014e-308",
        "1e-400",
        "1e400",
        "9007199254740993.0",
        "9007199254740993.0000001",
        "0.1",
        "123456789012345678901234567890",
        "1e22",
        "1e23",
        "0.0",
        "1_000.5",
    ] {
        let exact = Rational::from_decimal(literal).unwrap();
        let parsed: f64 = literal.replace('_', "").parse().unwrap();
        assert_eq!(exact.to_f64().to_bits(), parsed.to_bits(), "{literal}");
        assert_eq!(
            (-&exact).to_f64().abs().to_bits(),
            parsed.to_bits(),
            "−{literal}"
        );
    }
}

#[test]
fn only_literals_are_literals() {
    for text in [
        "",
        ".",
        "x",
        "1e",
        "e5",
        "1e5e5",
        "-1",
        "+1",
        ".-5",
        "1.-5",
        "1 2",
        "1e999999999",
        "0x10",
        "∞",
    ] {
        assert_eq!(Rational::from_decimal(text), None, "{text}");
    }
}
