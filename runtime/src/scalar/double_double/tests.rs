//! Tests of the digits beyond the precision of `f64`.

use std::string::ToString;

use num_traits::{One as _, Zero as _};

use super::DoubleDouble;
use crate::scalar::Scalar;

/// The relative tolerance.
const TOLERANCE: f64 = 1e-30;

fn number(value: f64) -> DoubleDouble {
    DoubleDouble::from_f64(value)
}

fn read(digits: &str) -> DoubleDouble {
    digits.parse().expect("a number")
}

#[track_caller]
fn assert_is(found: DoubleDouble, expected: &str) {
    let expected = read(expected);
    let error = ((found - expected) / expected).to_f64().abs();
    assert!(
        error <= TOLERANCE,
        "{found:?} is not {expected:?}: {error:e}"
    );
}

#[test]
fn arithmetic_has_twice_the_digits() {
    let third = number(1.0) / number(3.0);
    assert_is(third, "0.3333333333333333333333333333333333333333");
    assert_is(third * third, "0.1111111111111111111111111111111111111111");
    assert_is(
        third - number(0.25),
        "0.0833333333333333333333333333333333333333",
    );
    // Cancellation leaves the remainder exact.
    let small = number(1e-25);
    assert_eq!((number(1.0) + small) - number(1.0), small);
    assert_eq!(number(0.0) * third, DoubleDouble::zero());
    assert_eq!(third / third, DoubleDouble::one());
    assert_eq!(DoubleDouble::new(1e-25, 1.0), number(1.0) + small);
    assert_eq!((number(1.0) + small).low().to_bits(), 1e-25_f64.to_bits());
}

/// Compares with every line of the table, which `runtime/scripts/double_double_constants.py` computes with mpmath.
#[test]
fn functions_have_twice_the_digits() {
    type Function = fn(DoubleDouble) -> DoubleDouble;
    const FUNCTIONS: [(&str, Function); 15] = [
        ("sin", Scalar::sin),
        ("cos", Scalar::cos),
        ("tan", Scalar::tan),
        ("asin", Scalar::asin),
        ("acos", Scalar::acos),
        ("atan", Scalar::atan),
        ("sinh", Scalar::sinh),
        ("cosh", Scalar::cosh),
        ("tanh", Scalar::tanh),
        ("asinh", Scalar::asinh),
        ("acosh", Scalar::acosh),
        ("atanh", Scalar::atanh),
        ("exp", Scalar::exp),
        ("ln", Scalar::ln),
        ("sqrt", Scalar::sqrt),
    ];
    let mut compared = 0;
    for line in include_str!("functions.txt").lines().skip(1) {
        let words: std::vec::Vec<&str> = line.split(' ').collect();
        let [name, argument, expected] = words[..] else {
            panic!("{line}");
        };
        let (_, function) = FUNCTIONS
            .iter()
            .find(|(written, _)| *written == name)
            .expect("a function");
        let found = function(number(argument.parse().expect("an argument")));
        let expected = read(expected);
        let error = ((found - expected) / expected).to_f64().abs();
        assert!(error <= TOLERANCE, "{line}: {found}, {error:e}");
        compared += 1;
    }
    assert_eq!(compared, 256);
}

#[test]
fn functions_of_two_arguments_have_twice_the_digits() {
    let angle = number(-1.0).atan2(number(-2.0));
    assert_is(angle, "-2.677945044588987122248387151818288482169");
    let power = number(2.0).powf(number(0.75));
    assert_is(power, "1.68179283050742908606225095246642979008");
    assert_is(
        DoubleDouble::pi(),
        "3.14159265358979323846264338327950288419717",
    );
    assert_is(
        DoubleDouble::ratio(1.0, 7.0),
        "0.142857142857142857142857142857142857143",
    );
}

/// Near 1, at arguments of which `f64` holds only the first part.
#[test]
fn logarithms_keep_their_digits_near_one() {
    let power_of_two = |n: i32| libm::ldexp(1.0, n);
    let next = DoubleDouble::new(1.0, power_of_two(-60));
    assert_is(next.ln(), "8.673617379884035468298040484328213668081e-19");
    assert_is(
        next.acosh(),
        "0.000000001317089015965438493247580866420150864708",
    );
    let near = DoubleDouble::new(1.0 + power_of_two(-20), power_of_two(-75));
    assert_is(
        near.ln(),
        "0.0000009536738616591882603781698731353287684561",
    );
}

#[test]
fn powers_and_roots_are_those_of_real_numbers() {
    assert_is(number(-2.0).powf(number(3.0)), "-8");
    assert_is(number(-2.0).powf(number(-2.0)), "0.25");
    assert!(number(-2.0).powf(number(0.5)).to_f64().is_nan());
    assert!(number(-2.0).sqrt().to_f64().is_nan());
    assert!(number(-2.0).ln().to_f64().is_nan());
    assert_eq!(number(0.0).sqrt(), DoubleDouble::zero());
    assert_eq!(number(0.0).powf(number(2.0)), DoubleDouble::zero());
    assert!((number(1.0) / number(0.0)).to_f64().is_infinite());
    assert_eq!(number(0.0).atan2(number(0.0)), DoubleDouble::zero());
    assert_eq!(number(-3.0).signum(), number(-1.0));
}

#[test]
fn what_overflows_is_infinite() {
    let most = number(f64::MAX);
    for overflown in [most + most, most * number(2.0), number(800.0).exp()] {
        assert_eq!(overflown, number(f64::INFINITY));
    }
    assert_eq!(number(f64::INFINITY) + number(1.0), number(f64::INFINITY));
    assert_eq!(number(800.0).tanh(), number(1.0));
    assert_eq!(number(-800.0).exp(), number(0.0));
    assert!((most - most * number(2.0)).to_f64().is_infinite());
    assert!(!number(f64::NAN).is_finite());
}

/// Compares with values of mpmath, with 60 digits.
#[test]
fn functions_reach_to_the_largest_numbers() {
    let most = number(f64::MAX);
    assert_is(
        number(709.5).exp(),
        "1.354986319314632830876632274053603338299e+308",
    );
    assert_is(most.ln(), "709.782712893383996732223389910657145504");
    assert_is(most.asinh(), "710.475860073943942041640622032115322072");
    assert_is((-most).asinh(), "-710.475860073943942041640622032115322072");
    assert_is(
        number(1e41).asinh(),
        "95.09913599331581836035496821392489225545",
    );
    assert_is(
        number(9e39).asinh(),
        "92.69119038466394635899046485020615955682",
    );
    assert_eq!(number(f64::INFINITY).ln(), number(f64::INFINITY));
    assert_eq!(number(f64::INFINITY).asinh(), number(f64::INFINITY));
    assert!(number(f64::NAN).exp().to_f64().is_nan());
    // These results have the precision of `f64`.
    for (x, sine, cosine) in [
        (1e16, 0.779_688_006_606_978_8, -0.626_168_198_133_086_2),
        (1e22, -0.852_200_849_767_188_8, 0.523_214_785_395_139),
        (1e300, -0.817_881_912_115_908_5, -0.575_386_111_957_549_1),
    ] {
        let (found, other) = number(x).sin_cos();
        assert!((found.to_f64() - sine).abs() < 1e-15, "sin {x}: {found}");
        assert!((other.to_f64() - cosine).abs() < 1e-15, "cos {x}: {other}");
    }
    let (sine, _) = DoubleDouble::new(1e22, 0.5).sin_cos();
    assert!(
        (sine.to_f64() - -0.497_034_074_690_095_2).abs() < 1e-15,
        "{sine}"
    );
}

#[test]
fn digits_are_read_and_written() {
    let tenth = DoubleDouble::ratio(1.0, 10.0);
    for written in ["0.1", "1e-1", "+.1", "0.00010e3", "10E-2"] {
        assert_eq!(read(written), tenth, "{written}");
    }
    assert_eq!(read("-12.5"), number(-12.5));
    assert_eq!(read("-inf"), number(f64::NEG_INFINITY));
    assert_eq!(read("0e99999999999"), number(0.0));
    assert!("1.5x".parse::<DoubleDouble>().is_err());
    assert!("".parse::<DoubleDouble>().is_err());
    assert_eq!(tenth.to_string(), "1.0000000000000000000000000000000e-1");
    let third = number(-1.0) / number(3.0);
    assert_eq!(std::format!("{third:.20e}"), "-3.33333333333333333333e-1");
    assert_eq!(std::format!("{:.2e}", number(9.999)), "1.00e1");
    assert_eq!(std::format!("{:.0e}", number(250.0)), "3e2");
    assert_eq!(number(f64::NAN).to_string(), "NaN");
    for value in [1e300, 1.0, 1e-290, 123_456_789.0, 1e22] {
        let there_and_back = read(&number(value).to_string());
        let error = (there_and_back - number(value)) / number(value);
        assert!(error.to_f64().abs() < 1e-30, "{value:e}: {error}");
    }
    assert_is(
        read("3.14159265358979323846264338327950288419716939937510582097494459"),
        "3.1415926535897932384626433832795029",
    );
    assert_is(
        read("31415926535897932384626433832795028841971693993751.0"),
        "3.1415926535897932384626433832795029e49",
    );
}
