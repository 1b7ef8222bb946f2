//! Compares derivatives with differences, also where functions have none.

use super::Dual;
use crate::Scalar;

type OfThree = Dual<f64, 3>;

/// Evaluates every function of the trait that has derivatives, on arguments in its domain.
fn functions<S: Scalar>(x: S, y: S) -> [S; 34] {
    let one = S::one();
    let (sine, cosine) = x.sin_cos();
    let (sines, cosines) = S::sines_and_cosines([x * y, y]);
    [
        x + y,
        x - y,
        x * y,
        x / y,
        -x,
        x.mul_add(y, x),
        sine,
        cosine,
        sines[0],
        cosines[1],
        x.sin(),
        x.cos(),
        x.tan(),
        x.asin(),
        x.acos(),
        x.atan(),
        x.atan2(-y),
        x.sinh(),
        x.cosh(),
        x.tanh(),
        x.asinh(),
        (one + y).acosh(),
        x.atanh(),
        x.exp(),
        y.ln(),
        y.sqrt(),
        y.powf(x),
        (x - y).abs() * x.signum(),
        x.min(y) * x.floor(),
        x.max(y),
        x.logistic(),
        x.sech(),
        (x + y).log_cosh(),
        (x - y).softplus(),
    ]
}

/// Returns the central difference of order 4.
fn difference(f: impl Fn(f64) -> f64) -> f64 {
    let h = 1e-3;
    (8.0 * (f(h) - f(-h)) - (f(2.0 * h) - f(-2.0 * h))) / (12.0 * h)
}

#[test]
fn derivatives_are_the_limits_of_differences() {
    for (x, y) in [(0.3, 0.7), (-0.4, 1.3), (0.9, 0.2)] {
        // Along x, along y, and along neither.
        let [along_x, along_y] = [OfThree::variable(x, 0), OfThree::variable(y, 2)];
        let found = functions(along_x, along_y);
        let values = functions(x, y);
        for (i, (found, value)) in found.into_iter().zip(values).enumerate() {
            let slopes = found.derivative;
            let expected = [
                difference(|h| functions(x + h, y)[i]),
                difference(|h| functions(x, y + h)[i]),
            ];
            assert!((found.largest() - value).abs() < 1e-15, "{i} at {x}, {y}");
            let found = [slopes[0], slopes[2]];
            for (found, expected) in found.into_iter().zip(expected) {
                let error = (found - expected).abs() / (1.0 + expected.abs());
                assert!(error < 1e-8, "{i} at {x}, {y}: {found}, {expected}");
            }
            assert!(slopes[1].abs() < f64::MIN_POSITIVE);
        }
    }
}

#[test]
fn roots_of_nothing_have_no_slopes() {
    let root = OfThree::constant(0.0).sqrt();
    assert!(root.is_constant());
    let power = OfThree::variable(-2.0, 1).powf(OfThree::constant(3.0));
    assert!((power.derivative[1] - 12.0).abs() < 1e-12);
}

#[test]
fn powers_have_their_slopes_at_zero() {
    for (n, value, slope) in [
        (0.0, 1.0, 0.0),
        (1.0, 0.0, 1.0),
        (2.0, 0.0, 0.0),
        (2.5, 0.0, 0.0),
    ] {
        let base = OfThree::variable(0.0, 0);
        for exponent in [OfThree::constant(n), OfThree::variable(n, 1)] {
            let power = base.powf(exponent);
            let found = [power.value, power.derivative[0], power.derivative[1]];
            assert_eq!(
                found.map(f64::to_bits),
                [value, slope, 0.0].map(f64::to_bits),
                "{n}: {found:?}"
            );
        }
    }
}

/// At these distances the squares are not representable, but the angle, its slopes and its value are.
#[test]
fn angles_have_their_slopes_at_extreme_distances() {
    for n in [-1000, -700, -500, 0, 500, 700, 1000] {
        let unit = f64::powi(2.0, n);
        for (x, y) in [(1.25, 0.75), (-0.5, 1.5), (3.0, 0.0), (0.0, -2.0)] {
            let point = [(y, 0), (x, 2)];
            let [along_y, along_x] =
                point.map(|(value, index)| OfThree::variable(value * unit, index));
            let found = along_y.atan2(along_x);
            assert!((found.largest() - y.atan2(x)).abs() < 1e-15, "{n}");
            let square = x * x + y * y;
            for (index, expected) in [(0, x / square), (2, -y / square)] {
                let found = found.derivative[index] * unit;
                let error = (found - expected).abs();
                assert!(error < 1e-15, "{n} {x} {y}: {found} {expected}");
            }
        }
    }
}
