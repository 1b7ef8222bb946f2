//! What every scalar provides from the functions that it has.

use lagrangian::prelude::*;
use lagrangian::{DoubleDouble, Dual};

#[test]
fn whole_powers_are_those_of_the_standard_library() {
    for n in [-40, -3, -1, 0, 1, 2, 3, 7, 31, 200] {
        for x in [-1.7, 0.3, 1.0, 1.001] {
            let (found, expected) = (Scalar::powi(x, n), f64::powi(x, n));
            assert!((found / expected - 1.0).abs() < 1e-13, "{x} {n}");
            let derivative = Scalar::powi(Dual::<f64>::variable(x, 0), n).derivative[0];
            let expected = f64::from(n) * f64::powi(x, n - 1);
            assert!(
                (derivative - expected).abs() <= 1e-12 * expected.abs(),
                "{x} {n}"
            );
        }
    }
    assert_eq!(Scalar::powi(0.0_f64, 0).to_bits(), 1.0_f64.to_bits());
    assert_eq!(Scalar::powi(1.0_f64, i32::MIN).to_bits(), 1.0_f64.to_bits());
    let cube = Scalar::powi(DoubleDouble::from_f64(1.1), 3);
    let product =
        DoubleDouble::from_f64(1.1) * DoubleDouble::from_f64(1.1) * DoubleDouble::from_f64(1.1);
    assert!((cube - product).abs() < DoubleDouble::from_f64(1e-31));
}

#[test]
fn saturation_and_angles() {
    let clamped = [-3.0, 0.2, 5.0].map(|x| Scalar::clamp(x, -1.0, 2.0));
    assert_eq!(
        clamped.map(f64::to_bits),
        [-1.0, 0.2, 2.0].map(f64::to_bits)
    );
    assert!(Scalar::clamp(f64::NAN, -1.0, 2.0).is_nan());
    let slope =
        |x| Scalar::clamp(Dual::<f64>::variable(x, 0), (-1.0).into(), 2.0.into()).derivative[0];
    assert!((slope(0.5) - 1.0).abs() + slope(3.0).abs() < 1e-15);
    for scale in [1e-300, 1.0, 1e300] {
        let found = Scalar::hypot(3.0 * scale, 4.0 * scale);
        assert!((found / (5.0 * scale) - 1.0).abs() < 1e-15, "{scale}");
    }
    for degrees in [0.0, 30.0, -720.0] {
        assert!((Scalar::to_radians(degrees) - f64::to_radians(degrees)).abs() < 1e-14);
        assert!((Scalar::to_degrees(Scalar::to_radians(degrees)) - degrees).abs() < 1e-12);
    }
}

/// Numbers of which the type is not written are `f64`, also where their functions are called.
#[test]
fn the_type_of_numbers_need_not_be_written() {
    struct Spring;

    impl<S: Scalar> Dynamics<S> for Spring {
        type State = SVector<S, 2>;

        fn derivative(&self, _: S, x: &Self::State) -> Self::State {
            SVector::from([
                x[1],
                -x[0].powi(3).clamp(S::from_f64(-2.0), S::from_f64(2.0)),
            ])
        }
    }
    let start = At::from((0.0, SVector::from([1.0, 0.0])));
    let end = Problem::new(&Spring, start)
        .solve(1.0, Dop853::new())
        .unwrap();
    assert!((end.x[1].powi(2) / 2.0 + end.x[0].powi(4) / 4.0 - 0.25).abs() < 1e-9);
}
