//! Functions of dual numbers against closed forms of their first and second derivatives (Abramowitz and Stegun, Handbook of
//! Mathematical Functions, 1964, chapter 4), at the ends of their domains, and where functions have no derivative.
#![allow(clippy::float_cmp)] // Exact comparisons are meant.

use lagrangian::num_traits::Zero as _;
use lagrangian::prelude::*;
use lagrangian::{DoubleDouble, Dual};

/// A function: f, and f′ and f″ in closed form.
type Row<S, D> = (&'static str, fn(S) -> S, fn(D) -> [D; 2]);

fn number<S: Scalar>(value: f64) -> S {
    S::from_f64(value)
}

/// Circular functions at arguments between −1 and 1.
fn circular_functions<S: Scalar, D: Scalar>() -> [Row<S, D>; 8] {
    [
        ("sin", S::sin, |x| [x.cos(), -x.sin()]),
        ("cos", S::cos, |x| [-x.sin(), -x.cos()]),
        ("sin of both", |x| x.sin_cos().0, |x| [x.cos(), -x.sin()]),
        (
            "cos of several",
            |x| S::sines_and_cosines([x, -x]).1[1],
            |x| [-x.sin(), -x.cos()],
        ),
        ("tan", S::tan, |x| {
            let square = x.cos() * x.cos();
            [
                D::one() / square,
                number::<D>(2.0) * x.sin() / (square * x.cos()),
            ]
        }),
        ("asin", S::asin, |x| {
            let square = D::one() - x * x;
            [D::one() / square.sqrt(), x / (square * square.sqrt())]
        }),
        ("acos", S::acos, |x| {
            let square = D::one() - x * x;
            [-D::one() / square.sqrt(), -x / (square * square.sqrt())]
        }),
        ("atan", S::atan, |x| {
            let square = D::one() + x * x;
            [D::one() / square, -(x + x) / (square * square)]
        }),
    ]
}

/// Hyperbolic functions and exponentials at arguments between −1 and 1.
fn hyperbolic_functions<S: Scalar, D: Scalar>() -> [Row<S, D>; 9] {
    [
        ("sinh", S::sinh, |x| [x.cosh(), x.sinh()]),
        ("cosh", S::cosh, |x| [x.sinh(), x.cosh()]),
        ("tanh", S::tanh, |x| {
            let square = x.cosh() * x.cosh();
            [
                D::one() / square,
                number::<D>(-2.0) * x.sinh() / (square * x.cosh()),
            ]
        }),
        ("asinh", S::asinh, |x| {
            let square = D::one() + x * x;
            [D::one() / square.sqrt(), -x / (square * square.sqrt())]
        }),
        ("atanh", S::atanh, |x| {
            let square = D::one() - x * x;
            [D::one() / square, (x + x) / (square * square)]
        }),
        ("exp", S::exp, |x| [x.exp(), x.exp()]),
        ("sech", S::sech, |x| {
            let (sine, cosine) = (x.sinh(), x.cosh());
            let cube = cosine * cosine * cosine;
            [-sine / (cosine * cosine), (sine * sine - D::one()) / cube]
        }),
        ("logistic", S::logistic, |x| {
            let (small, whole) = ((-x).exp(), D::one() + (-x).exp());
            let first = small / (whole * whole);
            [first, first * (small - D::one()) / whole]
        }),
        ("ln cosh", S::log_cosh, |x| {
            let (sine, cosine) = (x.sinh(), x.cosh());
            [sine / cosine, D::one() / (cosine * cosine)]
        }),
    ]
}

/// Functions at positive arguments.
fn functions_of_positive<S: Scalar, D: Scalar>() -> [Row<S, D>; 5] {
    [
        ("ln", S::ln, |x| [D::one() / x, -D::one() / (x * x)]),
        (
            "acosh",
            |x| (S::one() + x).acosh(),
            |x| {
                let square = x * (x + number(2.0));
                let bend = -(D::one() + x) / (square * square.sqrt());
                [D::one() / square.sqrt(), bend]
            },
        ),
        ("softplus", S::softplus, |x| {
            let (small, whole) = ((-x).exp(), D::one() + (-x).exp());
            [D::one() / whole, small / (whole * whole)]
        }),
        ("sqrt", S::sqrt, |x| {
            let first = number::<D>(0.5) / x.sqrt();
            [first, -first / (x + x)]
        }),
        (
            "power",
            |x| x.powf(number(2.5)),
            |x| {
                let root = x.sqrt();
                [number::<D>(2.5) * x * root, number::<D>(3.75) * root]
            },
        ),
    ]
}

/// Functions of two arguments, along a line.
fn functions_of_two<S: Scalar, D: Scalar>() -> [Row<S, D>; 5] {
    [
        (
            "power of a negative",
            |x| (-x).powf(number(3.0)),
            |x| [number::<D>(-3.0) * x * x, number::<D>(-6.0) * x],
        ),
        (
            "power to itself",
            |x| x.powf(x),
            |x| {
                let (power, slope) = ((x * x.ln()).exp(), x.ln() + D::one());
                [power * slope, power * (slope * slope + D::one() / x)]
            },
        ),
        (
            "atan2",
            |x| x.atan2(number(-2.0)),
            |x| {
                let square = x * x + number(4.0);
                [
                    number::<D>(-2.0) / square,
                    number::<D>(4.0) * x / (square * square),
                ]
            },
        ),
        (
            "atan2 by its second argument",
            |x| number::<S>(1.0).atan2(x),
            |x| {
                let square = x * x + D::one();
                [-D::one() / square, (x + x) / (square * square)]
            },
        ),
        (
            "quotient",
            |x| (x + number(2.0)) / x,
            |x| {
                let first = number::<D>(-2.0) / (x * x);
                [first, -(first + first) / x]
            },
        ),
    ]
}

/// Fails unless a function of nested duals on a scalar has the derivatives of the closed form, to some roundings.
fn compare<S: Scalar>(
    rows: &[Row<Dual<Dual<S>>, DoubleDouble>],
    at: f64,
    to_exact: fn(S) -> DoubleDouble,
) {
    for (name, function, closed) in rows {
        let x = Dual::variable(Dual::variable(number(at), 0), 0);
        let [slope] = function(x).derivative;
        let [first, second] = closed(number(at));
        for (found, expected) in [(slope.value, first), (slope.derivative[0], second)] {
            let error = (to_exact(found) - expected).abs().to_f64();
            let allowed = 60.0 * S::machine_epsilon() * (1.0 + expected.abs().to_f64());
            assert!(
                error <= allowed,
                "{name} at {at}: {found:?}, {expected:?}: {error:e}"
            );
        }
    }
}

#[test]
fn derivatives_are_those_of_closed_forms() {
    for at in [-0.9, -0.3, 0.0, 0.125, 0.6, 0.95] {
        compare::<f64>(&circular_functions(), at, DoubleDouble::from);
        compare::<DoubleDouble>(&circular_functions(), at, |x| x);
        compare::<f64>(&hyperbolic_functions(), at, DoubleDouble::from);
        compare::<DoubleDouble>(&hyperbolic_functions(), at, |x| x);
    }
    for at in [0.03, 0.5, 1.25, 4.0] {
        compare::<f64>(&functions_of_positive(), at, DoubleDouble::from);
        compare::<DoubleDouble>(&functions_of_positive(), at, |x| x);
        compare::<f64>(&functions_of_two(), at, DoubleDouble::from);
        compare::<DoubleDouble>(&functions_of_two(), at, |x| x);
    }
}

/// f and f′, relative to f′.
#[track_caller]
fn assert_slope(found: Dual, expected: f64) {
    let error = (found.derivative[0] - expected).abs();
    assert!(
        error <= 20.0 * f64::EPSILON * expected.abs(),
        "{found:?}, expected {expected:e}"
    );
}

/// Where squares overflow, and where differences from 1 have no digits.
#[test]
fn slopes_keep_their_digits_far_out() {
    let at = |x: f64| Dual::variable(x, 0);
    assert_slope(at(1e200).asinh(), 1e-200);
    assert_slope(at(-1e200).asinh(), 1e-200);
    assert_slope(at(1e-200).asinh(), 1.0);
    assert_slope(at(1e200).acosh(), 1e-200);
    assert_slope(at(1.0 + f64::EPSILON).acosh(), (0.5 / f64::EPSILON).sqrt());
    assert_slope(at(1e150).atan(), 1e-300);
    assert_slope(at(20.0).tanh(), 4.0 * (-40.0_f64).exp());
    assert_slope(at(-300.0).tanh(), 4.0 * (-600.0_f64).exp());
    assert_slope(at(1.0 - f64::EPSILON).atanh(), 0.5 / f64::EPSILON);
    assert_slope(at(1.0 - f64::EPSILON).asin(), (0.5 / f64::EPSILON).sqrt());
    assert_slope(at(f64::EPSILON - 1.0).acos(), -(0.5 / f64::EPSILON).sqrt());
    assert_slope(Dual::new(1e-320, [1e-320]).ln(), 1.0);
    assert_slope(at(-800.0).sech(), 0.0);
    assert_slope(at(40.0).logistic(), (-40.0_f64).exp());
    assert_slope(at(0.001).powf(Dual::from(100.0)), 1e-295);
}

/// At the end of a domain, what has no derivative has a result without one, and what has one a slope beyond all sizes.
#[test]
fn ends_of_domains() {
    type Plane = Dual<f64, 2>;
    type End = (fn(Plane) -> Plane, f64);
    let ends: [End; 8] = [
        (Scalar::sqrt, 0.0),
        (Scalar::asin, 1.0),
        (Scalar::asin, -1.0),
        (Scalar::acos, 1.0),
        (Scalar::acosh, 1.0),
        (|x| x.powf(Dual::from(0.5)), 0.0),
        (|x| x.powf(Dual::from(1.0 / 3.0)), 0.0),
        (|x| x.powf(Dual::variable(0.5, 5)), 0.0),
    ];
    for (index, (function, end)) in ends.into_iter().enumerate() {
        let still = function(Dual::constant(end));
        assert!(
            still.derivative.iter().all(|x| *x == 0.0),
            "{index}: {still}"
        );
        let [along, across] = function(Dual::variable(end, 0)).derivative;
        assert!(along.abs() > 1e100, "{index}: {along}");
        assert!(across == 0.0, "{index}: {across}");
    }
    for end in [1.0, -1.0] {
        let [slope, across] = Dual::<f64, 2>::variable(end, 0).atanh().derivative;
        assert!(slope > 1e100 && across == 0.0);
    }
    // Twice nested, too.
    let roots: [fn(Dual<Dual>) -> Dual<Dual>; 5] = [
        Scalar::sqrt,
        |x| x.powf(Dual::from_f64(0.5)),
        |x| (x + 1.0).asin(),
        |x| (x + 1.0).acos(),
        |x| (x + 1.0).acosh(),
    ];
    for root in roots {
        let [slope] = root(Dual::zero()).derivative;
        assert!(slope.is_zero(), "{slope}");
    }
}

#[derive(Lagrangian)]
#[lagrangian(
    coordinates(x, y),
    kinetic = 0.5 * (dot(x).powi(2) + dot(y).powi(2)),
    force(
        x = max(x, y) + 2.0 * min(x, y) + abs(x) * y + signum(y) + x.powf(p),
        y = min(x, 0.0) + max(sin(x), x.powi(3)) + abs(dot(x)) * dot(x),
    ),
)]
struct Corners {
    p: f64,
}

/// At corners and jumps the conventions of derived derivatives hold.
#[test]
fn corners_have_the_derivatives_of_derived_ones() {
    for p in [0.0, 1.0, 2.0, 3.0] {
        for (q, v) in [
            ([0.0, 0.0], [0.0, 0.0]),
            ([0.5, 0.5], [0.0, 1.0]),
            ([-0.25, -0.25], [-1.0, 0.0]),
            ([0.0, 0.75], [0.5, 0.5]),
            ([0.75, 0.0], [0.0, 0.0]),
        ] {
            let model = Corners { p };
            let linearization = model.linearize(&State::new(0.0, q, v));
            let [x, y, u, w] = Dual::variables([q[0], q[1], v[0], v[1]]);
            let found = model.accelerations(&State::new(Dual::zero(), [x, y], [u, w]));
            for i in 0..2 {
                for j in 0..2 {
                    let [by_q, by_v] = [found[i].derivative[j], found[i].derivative[2 + j]];
                    let expected = (
                        linearization.position[(i, j)],
                        linearization.velocity[(i, j)],
                    );
                    assert_eq!((by_q, by_v), expected, "{p} {q:?} {v:?}: {i} {j}");
                }
            }
        }
    }
}

#[test]
fn the_lesser_of_equal_numbers_has_the_mean_of_both_slopes() {
    let [x, y] = Dual::variables([0.5, 0.5]);
    assert_eq!(x.min(y).derivative, [0.5, 0.5]);
    assert_eq!((x + x).max(y + x).derivative, [1.5, 0.5]);
    // Not where the other one's slope is beyond all sizes.
    let steep = Dual::new(0.75, [f64::INFINITY, f64::NAN]);
    assert_eq!(x.min(steep).derivative, [1.0, 0.0]);
    assert_eq!(steep.max(x).derivative[0], f64::INFINITY);
    let unknown = Dual::from(f64::NAN);
    assert_eq!(x.max(unknown).value, 0.5);
    assert_eq!(x.max(unknown).derivative, [1.0, 0.0]);
}

#[test]
fn comparisons_look_at_values() {
    let [x, y] = Dual::variables([1.0, 1.0]);
    assert!(x == y && x <= y && x >= y);
    assert!(x < Dual::from(2.0) && Dual::from(f64::NAN).partial_cmp(&x).is_none());
    assert!((x - y) == Dual::zero() && !(x - y).is_zero() && (x - x).is_zero());
    let nested = Dual::<Dual>::constant(Dual::variable(0.0, 0));
    assert!(nested == Dual::zero() && !nested.is_zero());
}

#[test]
fn numbers_are_shown_with_their_derivatives() {
    let x = Dual::new(2.5, [1.0]) / 3.0;
    assert_eq!(format!("{x:.3}"), "0.833 + 0.333ε");
    assert_eq!(
        Dual::<f64, 3>::variable(1.0, 2).to_string(),
        "1 + [0, 0, 1]ε"
    );
    assert_eq!(Dual::<f64, 2>::variable(1.0, 2), Dual::constant(1.0));
    assert!(Dual::<f64, 2>::variable(1.0, 2).derivative == [0.0, 0.0]);
}

#[test]
fn plain_numbers_are_the_right_operands_of_dual_ones() {
    let x = Dual::new(3.0, [2.0]);
    let found = [x + 1.0, x - 1.0, x * 4.0, x / 2.0];
    let expected = [(4.0, 2.0), (2.0, 2.0), (12.0, 8.0), (1.5, 1.0)];
    for (found, (value, slope)) in found.into_iter().zip(expected) {
        assert_eq!((found.value, found.derivative[0]), (value, slope));
    }
}
