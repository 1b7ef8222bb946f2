//! The precision of the scalar is that of the motion: order and tolerance of the Taylor method by default, for `f32`, `f64`
//! and double-doubles, against closed forms.

use lagrangian::prelude::*;
use lagrangian::{DoubleDouble, EquationsOfMotion};

/// The Kepler problem in the plane.
#[derive(Lagrangian)]
#[lagrangian(
    taylor,
    coordinates(x, y),
    kinetic = 0.5 * (dot(x).powi(2) + dot(y).powi(2)),
    potential = -1 / sqrt(x.powi(2) + y.powi(2)),
)]
struct Kepler;

/// ẍ = 6 x² of which x = 1/t² is a solution.
#[derive(Lagrangian)]
#[lagrangian(taylor, coordinates(x), kinetic = 0.5 * dot(x).powi(2), potential = -2.0 * x.powi(3))]
struct Cubic;

/// The largest error of a motion of eccentricity ½ after the time 8, at which Kepler's equation is solved in
/// double-doubles: t = E − ½ sin E.
fn kepler<S: Scalar, I>(method: I, number: impl Fn(DoubleDouble) -> S) -> f64
where
    I: Integrator<S, EquationsOfMotion<&'static Kepler, S, 2>>,
{
    let [time, eccentricity, one] = [8.0, 0.5, 1.0].map(DoubleDouble::from_f64);
    let start = State::new(
        S::zero(),
        [number(one - eccentricity), S::zero()],
        [S::zero(), number(DoubleDouble::from_f64(3.0).sqrt())],
    );
    let mut anomaly = time;
    for _ in 0..60 {
        let defect = anomaly - eccentricity * anomaly.sin() - time;
        anomaly = anomaly - defect / (one - eccentricity * anomaly.cos());
    }
    let minor = (one - eccentricity * eccentricity).sqrt();
    let expected = [anomaly.cos() - eccentricity, minor * anomaly.sin()].map(number);
    let end = Problem::new(&Kepler, start).solve(8.0, method).unwrap();
    let errors = [end.q[0] - expected[0], end.q[1] - expected[1]];
    errors
        .map(|error| error.abs().largest())
        .into_iter()
        .fold(0.0, f64::max)
}

#[test]
fn each_scalar_has_its_digits() {
    let single = |x: DoubleDouble| <f32 as Scalar>::from_f64(x.to_f64());
    let error = kepler(Taylor::order_12(), single);
    assert!(error < 5e-6, "f32: {error:e}");
    let error = kepler(Taylor::new(), single);
    assert!(error < 5e-6, "f32: {error:e}");

    let error = kepler(Taylor::new(), DoubleDouble::to_f64);
    assert!(error < 1e-14, "f64: {error:e}");

    for error in [
        kepler(Taylor::order_40(), |x| x),
        kepler(Taylor::new(), |x| x),
    ] {
        assert!(error < 1e-29, "double-double: {error:e}");
    }
}

#[test]
fn a_tolerance_is_met_by_all_scalars() {
    for tolerance in [1e-8, 1e-16, 1e-24] {
        let method = Taylor::order_40().relative_tolerance(tolerance);
        let error = kepler(method, |x| x);
        assert!(error < 100.0 * tolerance, "{tolerance:e}: {error:e}");
    }
}

#[test]
fn many_digits_near_a_pole() {
    let number = DoubleDouble::from_f64;
    let start = State::new(number(-4.0), [number(0.0625)], [number(0.03125)]);
    let end = Problem::new(&Cubic, start).solve(-0.25, Taylor::order_40());
    let error = (end.unwrap().q[0] - number(16.0)).abs().to_f64();
    assert!(error < 1e-25, "{error:e}");
}
