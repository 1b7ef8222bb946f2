//! Digits beyond those of `f64`.

use lagrangian::Scalar as _;
use num_traits::{One as _, Zero as _};

use super::DoubleDouble;

/// Relative to what is expected.
const TOLERANCE: f64 = 1e-30;

fn number(value: f64) -> DoubleDouble {
    DoubleDouble::from_f64(value)
}

#[track_caller]
fn assert_is(found: DoubleDouble, expected: &str) {
    let expected = DoubleDouble::parse(expected);
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
    // What cancels leaves the rest exactly.
    let small = number(1e-25);
    assert_eq!((number(1.0) + small) - number(1.0), small);
    assert_eq!(number(0.0) * third, DoubleDouble::zero());
    assert_eq!(third / third, DoubleDouble::one());
}

/// The expected numbers are mpmath's.
#[test]
fn functions_have_twice_the_digits() {
    assert_is(
        number(1.0).sin(),
        "0.8414709848078965066525023216302989996226",
    );
    assert_is(
        number(1.0).cos(),
        "0.5403023058681397174009366074429766037323",
    );
    assert_is(
        number(10.0).sin(),
        "-0.5440211108893698134047476618513772816836",
    );
    assert_is(
        number(10.0).cos(),
        "-0.8390715290764524522588639478240648345199",
    );
    assert_is(
        number(1.0).tan(),
        "1.557407724654902230506974807458360173087",
    );
    assert_is(
        number(0.75).asin(),
        "0.8480620789814810080529443389984180800734",
    );
    assert_is(
        number(0.75).acos(),
        "0.7227342478134156111783773526413333620252",
    );
    assert_is(
        number(0.25).atan(),
        "0.2449786631268641541720824812112758109141",
    );
    let angle = number(-1.0).atan2(number(-2.0));
    assert_is(angle, "-2.677945044588987122248387151818288482169");
    assert_is(
        number(1.0).exp(),
        "2.718281828459045235360287471352662497757",
    );
    let small = number(-20.0).exp();
    assert_is(small, "0.000000002061153622438557827965940380155820976376");
    assert_is(
        number(10.0).ln(),
        "2.302585092994045684017991454684364207601",
    );
    assert_is(
        number(2.0).sqrt(),
        "1.41421356237309504880168872420969807857",
    );
    let power = number(2.0).powf(number(0.75));
    assert_is(power, "1.68179283050742908606225095246642979008");
    assert_is(
        number(0.5).sinh(),
        "0.5210953054937473616224256264114915591059",
    );
    let small = number(0.000_976_562_5).sinh();
    assert_is(small, "0.0009765626552204365040667515006385380733248");
    assert_is(
        number(0.5).cosh(),
        "1.127625965206380785226225161402672012548",
    );
    assert_is(
        number(0.5).tanh(),
        "0.4621171572600097585023184836436725487303",
    );
    assert_is(
        number(0.5).asinh(),
        "0.4812118250596034474977589134243684231352",
    );
    assert_is(
        number(1.5).acosh(),
        "0.9624236501192068949955178268487368462704",
    );
    assert_is(
        number(0.5).atanh(),
        "0.5493061443340548456976226184612628523237",
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
