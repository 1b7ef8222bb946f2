//! The check of declared derivatives: wrong ones are detected, right ones are accepted.
#![allow(clippy::float_cmp, clippy::cast_possible_truncation)] // Exact comparisons and `f32` are meant.

use core::ops::RangeInclusive;

use lagrangian::{
    CheckDerivatives as _, DerivativeError, ExternalFunctions, FunctionSignature, check_derivatives,
};

type Function = fn(f64) -> f64;

/// A right derivative and a region, on which the function may be steep, large, small or kinked.
const RIGHT: [(&str, Function, Function, RangeInclusive<f64>); 20] = [
    ("constant", |_| 3.0, |_| 0.0, -1.0..=1.0),
    ("line", |x| 1e12 * x + 1.0, |_| 1e12, -1e3..=1e3),
    ("sin", f64::sin, f64::cos, -7.0..=7.0),
    (
        "over whole periods",
        |x| (core::f64::consts::TAU * x).sin(),
        |x| core::f64::consts::TAU * (core::f64::consts::TAU * x).cos(),
        0.0..=8.0,
    ),
    (
        "fast",
        |x| (1e5 * x).sin(),
        |x| 1e5 * (1e5 * x).cos(),
        -3.0..=3.0,
    ),
    (
        "steep",
        |v| (1e3 * v).tanh(),
        |v| 1e3 * (1e3 * v).cosh().powi(-2),
        -3.0..=3.0,
    ),
    (
        "steeper",
        |v| (1e6 * v).tanh(),
        |v| 1e6 * (1e6 * v).cosh().powi(-2),
        -1e-5..=1e-5,
    ),
    ("exp", f64::exp, f64::exp, -50.0..=50.0),
    ("small", |x| 1e-200 * x * x, |x| 2e-200 * x, -1.0..=1.0),
    (
        "short",
        |x| (1e9 * x).sin(),
        |x| 1e9 * (1e9 * x).cos(),
        1e-9..=2e-9,
    ),
    (
        "far away",
        |x| (x - 1e9).powi(3),
        |x| 3.0 * (x - 1e9).powi(2),
        1e9..=1_000_000_002.0,
    ),
    ("on an offset", |x| 1e6 + x.sin(), f64::cos, -3.0..=3.0),
    ("root", f64::sqrt, |x| 0.5 / x.sqrt(), 0.0..=1.0),
    ("pole", |x| 1.0 / x, |x| -1.0 / (x * x), 1e-6..=1.0),
    ("logarithm", f64::ln, |x| 1.0 / x, 1e-300..=1.0),
    ("absolute value", f64::abs, f64::signum, -1.0..=1.0),
    ("signum", f64::signum, |_| 0.0, -1.0..=1.0),
    (
        "dead zone",
        |x| (x.abs() - 0.5).max(0.0) * x.signum(),
        |x| if x.abs() < 0.5 { 0.0 } else { 1.0 },
        -2.0..=2.0,
    ),
    (
        "bump",
        |x| {
            if x.abs() < 1.0 {
                (-1.0 / (1.0 - x * x)).exp()
            } else {
                0.0
            }
        },
        |x| {
            let below = 1.0 - x * x;
            if below > 0.0 {
                -2.0 * x / below.powi(2) * (-1.0 / below).exp()
            } else {
                0.0
            }
        },
        -2.0..=2.0,
    ),
    (
        "single precision",
        |x| f64::from((x as f32).sin()),
        f64::cos,
        -3.0..=3.0,
    ),
];

#[test]
fn right_derivatives_are_right() {
    for (name, value, derivative, region) in RIGHT {
        let found = check_derivatives(|[x]| value(x), |[x]| [derivative(x)], [region]);
        assert_eq!(found, Ok(()), "{name}");
    }
}

#[test]
fn derivatives_may_be_inexact_themselves() {
    let check = |error: f64| {
        check_derivatives(|[x]| x.sin(), |[x]| [x.cos() * (1.0 + error)], [-3.0..=3.0])
    };
    assert_eq!(check(5e-9), Ok(()));
    assert!(check(5e-8).is_err());
}

#[test]
#[ignore = "a long sweep; run with `--include-ignored`"]
fn wrong_derivatives_are_wrong() {
    detect_wrong_derivatives(1);
}

#[test]
fn some_wrong_derivatives_are_wrong() {
    detect_wrong_derivatives(4);
}

/// One of so many ways to be wrong, which differ from function to function.
fn detect_wrong_derivatives(stride: usize) {
    for (first, (name, value, derivative, region)) in RIGHT.into_iter().enumerate() {
        let finest = if name == "single precision" {
            1e-2
        } else {
            1e-5
        };
        let size = derivative(0.3 * region.start() + 0.7 * region.end()).abs();
        let shift = if size > 0.0 { 1e-2 * size } else { 1e-2 };
        let wrong: [(&str, &dyn Fn(f64) -> f64); 6] = [
            ("scaled", &|x| derivative(x) * (1.0 + finest)),
            ("turned", &|x| -derivative(x)),
            ("none", &|_| 0.0),
            ("shifted", &|x| derivative(x) + shift),
            ("no number", &|_| f64::NAN),
            ("infinite", &|_| f64::INFINITY),
        ];
        for (how, wrong) in wrong.into_iter().skip(first % stride).step_by(stride) {
            // What is flat has no other derivative; and where a function is steep is to be said.
            let flat = ["constant", "signum"].contains(&name);
            let same = ["scaled", "turned", "none"].contains(&how);
            if flat && same || (name, how) == ("steep", "scaled") {
                continue;
            }
            let found = check_derivatives(|[x]| value(x), |[x]| [wrong(x)], [region.clone()]);
            assert!(
                matches!(found, Err(DerivativeError::Wrong { .. })),
                "{name}, {how}: {found:?}"
            );
        }
    }
}

#[test]
fn each_argument_has_its_derivative() {
    let value = |[x, y]: [f64; 2]| x * x * (3.0 * y).sin();
    let along = |[x, y]: [f64; 2]| 2.0 * x * (3.0 * y).sin();
    let across = |[x, y]: [f64; 2]| 3.0 * x * x * (3.0 * y).cos();
    let region = || [-1.0..=2.0, 0.0..=5.0];
    let right = check_derivatives(value, |x| [along(x), across(x)], region());
    assert_eq!(right, Ok(()));
    let exchanged = check_derivatives(value, |x| [across(x), along(x)], region());
    let Err(DerivativeError::Wrong { argument, .. }) = exchanged else {
        panic!("{exchanged:?}");
    };
    assert_eq!(argument, "x₁");
    let second = check_derivatives(value, |x| [along(x), along(x)], region());
    let Err(DerivativeError::Wrong {
        argument,
        point,
        declared,
        measured,
        uncertainty,
        ..
    }) = second
    else {
        panic!("{second:?}");
    };
    assert_eq!(argument, "x₂");
    let values: Vec<_> = point.iter().collect();
    let [("x₁", x), ("x₂", y)] = values[..] else {
        panic!("{values:?}");
    };
    assert_eq!(declared, along([x, y]));
    assert!((measured - across([x, y])).abs() <= uncertainty);
    // A constant argument is not checked.
    let held = check_derivatives(value, |x| [along(x), f64::NAN], [-1.0..=2.0, 0.7..=0.7]);
    assert_eq!(held, Ok(()));
}

#[test]
fn a_check_that_is_impossible_is_an_error() {
    let check = |value: Function, region| check_derivatives(|[x]| value(x), |_| [1.0], [region]);
    let text = |found: Result<(), DerivativeError>| found.unwrap_err().to_string();
    assert_eq!(
        text(check(f64::sqrt, -1.0..=1.0)).split_once(" where "),
        Some((
            "`f` is NaN",
            "x₁ = -0.7639320225002102: choose a region in which it has values"
        )),
    );
    // Random values, by a hash.
    let noise = |x: f64| f64::from((x.to_bits().wrapping_mul(0x9e37_79b9_7f4a_7c15) >> 40) as u32);
    assert_eq!(
        text(check(noise, -1.0..=1.0)),
        "no numerical derivative ∂f/∂x₁ is accurate: the values jump or are noisy everywhere in this region"
    );
    let invalid = "the range of `x₁`, an argument of `f`, must be finite and not empty";
    #[allow(clippy::reversed_empty_ranges)] // That is what is refused.
    for range in [1.0..=-1.0, 0.0..=f64::INFINITY, f64::NAN..=1.0] {
        assert_eq!(text(check(f64::sin, range)), invalid);
    }
}

/// Two functions, of which the second is the derivative of the first up to a factor.
struct Slider {
    width: f64,
    factor: f64,
}

impl ExternalFunctions for Slider {
    type Scalar = f32;

    const FUNCTIONS: &'static [FunctionSignature] = &[
        FunctionSignature {
            name: "friction",
            arguments: &["v"],
        },
        FunctionSignature {
            name: "slope",
            arguments: &["v"],
        },
        FunctionSignature {
            name: "wear",
            arguments: &["v", "load"],
        },
    ];

    fn function(&self, function: usize, arguments: &[f32]) -> f32 {
        let width = self.width as f32;
        match (function, arguments) {
            (0, [v]) => (v / width).tanh(),
            (1, [v]) => (v / width).cosh().powi(-2) / width,
            (2, [v, load]) => v * v * load,
            _ => f32::NAN,
        }
    }

    fn derivative(&self, function: usize, argument: usize, x: &[f32]) -> Option<f32> {
        match (function, argument) {
            (0, 0) => Some(self.factor as f32 * self.function(1, x)),
            (2, 0) => Some(2.0 * x[0] * x[1]),
            _ => None,
        }
    }
}

#[test]
fn models_check_their_functions_by_name() {
    let slider = Slider {
        width: 0.1,
        factor: 1.0,
    };
    assert_eq!(slider.check_derivatives("friction", [-0.5..=0.5]), Ok(()));
    // One of two derivatives is declared.
    assert_eq!(
        slider.check_derivatives("wear", [-0.5..=0.5, 0.0..=1.0]),
        Ok(())
    );
    let wrong = Slider {
        factor: 1.01,
        ..slider
    };
    let text = wrong
        .check_derivatives("friction", [-0.5..=0.5])
        .unwrap_err()
        .to_string();
    assert!(
        text.starts_with("the declared derivative ∂friction/∂v is 10.09"),
        "{text}"
    );
    assert!(
        text.contains(", but the numerical derivative of `friction` there is 9.99"),
        "{text}"
    );
    for (name, text) in [
        (
            "stribeck",
            "there is no function of this name; those of the declaration are `friction`, `slope`, `wear`",
        ),
        ("slope", "no derivative of `slope` is declared"),
        (
            "wear",
            "`wear` has 2 arguments: write a range for each, not 1",
        ),
    ] {
        let found = wrong.check_derivatives(name, [-0.5..=0.5]);
        assert_eq!(found.unwrap_err().to_string(), text);
    }
}
