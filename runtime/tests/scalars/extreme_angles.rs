//! Angles atan2(y, x) of points at distances from 1e-300 to 1e300, with coordinates of like and of unlike magnitude: values,
//! slopes, second derivatives and Taylor coefficients are right wherever they are numbers.
//!
//! Expected values are computed with 60 digits by mpmath from the exact values of the coordinates: with q = x² + y²,
//! `atan2(y, x)`, `[-y/q, x/q]`, `[2*x*y/q**2, (y*y - x*x)/q**2]`, and along (x + x t/4, y − y t/2) the coefficients of the series
//! of θ′ = (x y′ − y x′)/q by long division; a value beyond the range of f64 is infinite.

use lagrangian::prelude::*;
use lagrangian::{DoubleDouble, Dual, Lanes, Series, TaylorCoefficients};

/// q̈ is the gradient of the angle.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(x, y),
    kinetic = 0.5 * (dot(x).powi(2) + dot(y).powi(2)),
    potential = -atan2(y, x),
)]
struct Gradient;

/// z̈ is the angle of a point that moves uniformly.
#[derive(Lagrangian)]
#[lagrangian(
    taylor,
    coordinates(x, y, z),
    kinetic = 0.5 * (dot(x).powi(2) + dot(y).powi(2) + dot(z).powi(2)),
    force(z = atan2(y, x)),
)]
struct Swept;

/// ü is the rate of the angle of a point that moves uniformly.
#[derive(Lagrangian)]
#[lagrangian(
    taylor,
    coordinates(x, y, u),
    kinetic = 0.5 * (dot(x).powi(2) + dot(y).powi(2) + dot(u).powi(2)),
    force(u = dot(atan2(y, x))),
)]
struct Rate;

/// (x, y), both slopes, the second derivatives by x twice and by x and y, and the coefficients of the angle.
type Row = ([f64; 2], [f64; 2], [f64; 2], [f64; 5]);

/// Ten roundings, and as much below the smallest number with all digits.
fn assert_near(found: f64, expected: f64, what: &str, [x, y]: [f64; 2]) {
    if expected.is_infinite() {
        return;
    }
    let allowed = 10.0 * f64::EPSILON * (expected.abs() + f64::MIN_POSITIVE);
    assert!(
        (found - expected).abs() <= allowed,
        "{what} at ({x:e}, {y:e}): {found:e}, expected {expected:e}"
    );
}

fn is_finite(second: [f64; 2]) -> bool {
    second.into_iter().all(f64::is_finite)
}

fn assert_all_near(found: &[f64], expected: &[f64], what: &str, at: [f64; 2]) {
    assert_eq!(found.len(), expected.len());
    for (found, expected) in found.iter().zip(expected) {
        assert_near(*found, *expected, what, at);
    }
}

fn at_rest<S: Scalar, const N: usize>(q: [S; N]) -> State<S, N> {
    State::new(S::zero(), q, [S::zero(); N])
}

#[test]
fn slopes_and_second_derivatives_are_those_of_the_angle() {
    for (at, slopes, second, _) in ANGLES {
        let state = at_rest(at);
        let found = Gradient.accelerations(&state);
        assert_all_near(found.as_slice(), &slopes, "slopes", at);
        let found = Gradient.linearize(&state).position;
        let found = [found[(0, 0)], found[(0, 1)], found[(1, 0)], -found[(1, 1)]];
        let expected = [second[0], second[1], second[1], second[0]];
        assert_all_near(&found, &expected, "second derivatives", at);
    }
}

#[test]
fn slopes_on_other_scalars_are_those_of_the_angle() {
    for (at, slopes, _, _) in ANGLES {
        let lanes = Gradient.accelerations(&at_rest(at.map(|x| Lanes([1.0, x]))));
        let found = [lanes[0].in_lane(1), lanes[1].in_lane(1)];
        assert_all_near(&found, &slopes, "slopes in lanes", at);

        // Below, the lower part has no digits.
        if at.iter().all(|x| x.abs() > 1e-290 || *x == 0.0) {
            let exact = Gradient.accelerations(&at_rest(at.map(DoubleDouble::from_f64)));
            let found = [exact[0].largest(), exact[1].largest()];
            assert_all_near(&found, &slopes, "slopes on double-doubles", at);
        }
    }
}

#[test]
fn slopes_on_dual_numbers_are_those_of_the_angle() {
    // Products of derivative parts are as large as 1/(x² + y²).
    for (at, _, second, _) in ANGLES.into_iter().filter(|row| is_finite(row.2)) {
        let moving = [Dual::new(at[0], [1.0]), Dual::from(at[1])];
        let dual = Gradient.accelerations(&at_rest(moving));
        assert_all_near(
            &[dual[0].derivative[0], dual[1].derivative[0]],
            &second,
            "slopes on dual numbers",
            at,
        );
    }
}

#[test]
fn derivative_parts_of_an_angle_are_its_derivatives() {
    for (at, slopes, second, coefficients) in ANGLES {
        let [x, y] = at;
        let variables = Dual::variables([x, y]);
        let angle = variables[1].atan2(variables[0]);
        let [by_x, by_y] = angle.derivative;
        assert_all_near(
            &[angle.value, by_x, by_y],
            &[coefficients[0], slopes[0], slopes[1]],
            "vectors",
            at,
        );

        let exact = Scalar::atan2(DoubleDouble::from_f64(y), DoubleDouble::from_f64(x));
        assert_near(exact.largest(), coefficients[0], "double-double", at);

        if is_finite(second) {
            let twice = Dual::variables(Dual::variables([x, y]));
            let [by_x, _] = twice[1].atan2(twice[0]).derivative;
            assert_all_near(&by_x.derivative, &second, "second parts", at);
        }
    }
}

#[test]
fn series_of_an_angle_have_its_coefficients() {
    for (at, _, _, coefficients) in ANGLES {
        let [x, y] = at;
        let state = State::new(0.0, [x, y, 0.0], [0.25 * x, -0.5 * y, 0.0]);
        let mut series = TaylorCoefficients::<_, 4>::new(Phase::from(state));
        Swept
            .dynamics()
            .series((0.0, &state.into()), 1.0, &mut series, None);
        let orders = [1.0, 2.0, 3.0, 4.0, 5.0].into_iter();
        let found = orders
            .zip(series.higher())
            .map(|(order, term)| order * term.v[2]);
        assert_all_near(
            &found.collect::<Vec<_>>(),
            &coefficients,
            "coefficients",
            at,
        );
    }
}

#[test]
fn series_of_a_rate_have_its_coefficients() {
    for (at, _, _, coefficients) in ANGLES {
        let [x, y] = at;
        let state = State::new(0.0, [x, y, 0.0], [0.25 * x, -0.5 * y, 0.0]);
        let mut series = TaylorCoefficients::<_, 4>::new(Phase::from(state));
        Rate.dynamics()
            .series((0.0, &state.into()), 1.0, &mut series, None);
        let found: Vec<_> = series.higher()[..4].iter().map(|term| term.v[2]).collect();
        assert_all_near(&found, &coefficients[1..], "coefficients", at);
    }
}

/// Points in the unit 1. In another unit, which is a power of two, the angle is the same, and its slopes are divided by the unit.
const POINTS: [[f64; 2]; 4] = [[1.25, 0.75], [-0.5, 1.5], [3.0, 0.0], [0.0, -2.0]];

#[test]
fn slopes_and_series_on_f32_are_those_of_the_angle() {
    for n in [-120, -100, -63, 0, 63, 100, 120] {
        let unit = f32::powi(2.0, n);
        #[allow(clippy::cast_possible_truncation)] // They have a few digits.
        for [x, y] in POINTS.map(|point| point.map(|x| x as f32)) {
            let at = [x * unit, y * unit];
            let square = x * x + y * y;
            let near = |found: f32, expected: f32, what: &str| {
                let error = (found - expected).abs();
                assert!(
                    error <= 4.0 * f32::EPSILON * expected.abs(),
                    "{what} at {at:?}: {found:e}, expected {expected:e}"
                );
            };
            let slopes = Gradient.accelerations(&at_rest(at));
            near(slopes[0] * unit, -y / square, "∂/∂x");
            near(slopes[1] * unit, x / square, "∂/∂y");

            // At the velocity of the unit along x: θ = arg(x + t, y).
            let state = State::new(0.0, [at[0], at[1], 0.0], [unit, 0.0, 0.0]);
            let mut series = TaylorCoefficients::<_, 4>::new(Phase::from(state));
            Swept
                .dynamics()
                .series((0.0, &state.into()), 1.0, &mut series, None);
            let mut terms = series.higher();
            let mut term = |order: f32| {
                let (first, rest) = terms.split_first().unwrap();
                terms = rest;
                order * first.v[2]
            };
            near(term(1.0), y.atan2(x), "angle");
            near(term(2.0), -y / square, "rate");
            near(term(3.0), x * y / (square * square), "second coefficient");
        }
    }
}

#[rustfmt::skip]
#[allow(clippy::unreadable_literal, clippy::approx_constant)] // As mpmath prints them.
const ANGLES: [Row; 38] = [
    ([1.25e-300, 7.5e-301], [-3.529411764705882e+299, 5.88235294117647e+299], [f64::INFINITY, f64::NEG_INFINITY], [0.5404195002705842, -0.33088235294117646, 0.017030709342560547, 0.011198764756767761, -0.0018194572697285707]),
    ([-5e-301, 1.5e-300], [-5.9999999999999996e+299, -1.9999999999999997e+299], [f64::NEG_INFINITY, f64::INFINITY], [1.8925468811915387, 0.22499999999999998, 0.095625, 0.03684375, 0.012431250000000001]),
    ([1.25e-200, 7.5e-201], [-3.5294117647058824e+199, 5.882352941176471e+199], [f64::INFINITY, f64::NEG_INFINITY], [0.5404195002705842, -0.33088235294117646, 0.017030709342560554, 0.01119876475676776, -0.0018194572697285713]),
    ([-5e-201, 1.5e-200], [-6e+199, -2e+199], [f64::NEG_INFINITY, f64::INFINITY], [1.892546881191539, 0.225, 0.095625, 0.03684375, 0.01243125]),
    ([1.25e-160, 7.5e-161], [-3.529411764705882e+159, 5.882352941176471e+159], [f64::INFINITY, f64::NEG_INFINITY], [0.5404195002705842, -0.33088235294117646, 0.017030709342560554, 0.01119876475676776, -0.0018194572697285713]),
    ([-5e-161, 1.5e-160], [-6e+159, -2e+159], [f64::NEG_INFINITY, f64::INFINITY], [1.892546881191539, 0.225, 0.095625, 0.03684375, 0.01243125]),
    ([1.25e-155, 7.5e-156], [-3.5294117647058826e+154, 5.882352941176471e+154], [f64::INFINITY, f64::NEG_INFINITY], [0.5404195002705842, -0.33088235294117646, 0.017030709342560554, 0.011198764756767758, -0.0018194572697285715]),
    ([-5e-156, 1.5e-155], [-6e+154, -2e+154], [f64::NEG_INFINITY, f64::INFINITY], [1.892546881191539, 0.225, 0.095625, 0.03684375, 0.01243125]),
    ([1.25e-153, 7.5e-154], [-3.529411764705882e+152, 5.882352941176471e+152], [4.152249134948096e+305, -2.2145328719723184e+305], [0.5404195002705842, -0.33088235294117646, 0.01703070934256056, 0.011198764756767758, -0.0018194572697285717]),
    ([-5e-154, 1.5e-153], [-6e+152, -2e+152], [-2.4000000000000002e+305, 3.2e+305], [1.892546881191539, 0.225, 0.095625, 0.03684375, 0.01243125]),
    ([1.25e-80, 7.5e-81], [-3.5294117647058825e+79, 5.8823529411764706e+79], [4.152249134948097e+159, -2.2145328719723184e+159], [0.5404195002705842, -0.33088235294117646, 0.01703070934256055, 0.01119876475676776, -0.001819457269728571]),
    ([-5e-81, 1.5e-80], [-6e+79, -2e+79], [-2.4e+159, 3.2e+159], [1.8925468811915387, 0.22499999999999998, 0.095625, 0.03684375, 0.012431250000000001]),
    ([1.25, 0.75], [-0.35294117647058826, 0.5882352941176471], [0.41522491349480967, -0.22145328719723184], [0.5404195002705842, -0.33088235294117646, 0.017030709342560554, 0.01119876475676776, -0.0018194572697285713]),
    ([-0.5, 1.5], [-0.6, -0.2], [-0.24, 0.32], [1.892546881191539, 0.225, 0.095625, 0.03684375, 0.01243125]),
    ([1.25e+80, 7.5e+79], [-3.5294117647058827e-81, 5.882352941176471e-81], [4.152249134948098e-161, -2.2145328719723187e-161], [0.5404195002705842, -0.33088235294117646, 0.01703070934256055, 0.01119876475676776, -0.001819457269728571]),
    ([-5e+79, 1.5e+80], [-6e-81, -2.0000000000000002e-81], [-2.4000000000000004e-161, 3.2000000000000002e-161], [1.892546881191539, 0.225, 0.095625, 0.03684375, 0.01243125]),
    ([1.25e+153, 7.5e+152], [-3.5294117647058825e-154, 5.88235294117647e-154], [4.152249134948097e-307, -2.214532871972318e-307], [0.5404195002705842, -0.33088235294117646, 0.01703070934256055, 0.01119876475676776, -0.001819457269728571]),
    ([-5e+152, 1.5e+153], [-5.999999999999999e-154, -1.9999999999999996e-154], [-2.3999999999999998e-307, 3.1999999999999997e-307], [1.8925468811915387, 0.22499999999999998, 0.095625, 0.03684375, 0.012431250000000001]),
    ([1.25e+155, 7.5e+154], [-3.5294117647058826e-156, 5.88235294117647e-156], [4.152249134948e-311, -2.2145328719723e-311], [0.5404195002705842, -0.33088235294117646, 0.017030709342560547, 0.011198764756767761, -0.0018194572697285709]),
    ([-5e+154, 1.5e+155], [-5.999999999999999e-156, -1.9999999999999998e-156], [-2.4e-311, 3.2e-311], [1.892546881191539, 0.225, 0.095625, 0.03684375, 0.012431250000000001]),
    ([1.25e+160, 7.5e+159], [-3.529411764705882e-161, 5.882352941176471e-161], [4.15e-321, -2.213e-321], [0.5404195002705842, -0.33088235294117646, 0.01703070934256056, 0.011198764756767756, -0.001819457269728572]),
    ([-5e+159, 1.5e+160], [-6.0000000000000006e-161, -2e-161], [-2.4e-321, 3.2e-321], [1.892546881191539, 0.225, 0.095625, 0.03684375, 0.01243125]),
    ([1.25e+200, 7.5e+199], [-3.529411764705882e-201, 5.882352941176471e-201], [0.0, -0.0], [0.5404195002705842, -0.33088235294117646, 0.01703070934256056, 0.011198764756767758, -0.0018194572697285717]),
    ([-5e+199, 1.5e+200], [-6e-201, -2e-201], [-0.0, 0.0], [1.892546881191539, 0.225, 0.095625, 0.03684375, 0.01243125]),
    ([1.25e+300, 7.5e+299], [-3.5294117647058823e-301, 5.882352941176471e-301], [0.0, -0.0], [0.5404195002705842, -0.33088235294117646, 0.017030709342560554, 0.01119876475676776, -0.0018194572697285713]),
    ([-5e+299, 1.5e+300], [-6e-301, -1.9999999999999997e-301], [-0.0, 0.0], [1.892546881191539, 0.225, 0.095625, 0.03684375, 0.01243125]),
    ([1e+200, 1e-200], [-0.0, 1e-200], [0.0, -0.0], [0.0, -0.0, 0.0, -0.0, 0.0]),
    ([1e-200, 1e+200], [-1e-200, 0.0], [0.0, 0.0], [1.5707963267948966, -0.0, -0.0, -0.0, -0.0]),
    ([-1e+300, 3e-300], [-0.0, -1e-300], [-0.0, -0.0], [3.141592653589793, 0.0, -0.0, 0.0, -0.0]),
    ([3e-170, 2e-155], [-5e+154, 7.5e+139], [7.5e+294, f64::INFINITY], [1.5707963267948952, -1.125e-15, -5.625e-16, -2.8125e-16, -1.40625e-16]),
    ([5e+100, -7e+170], [1.4285714285714286e-171, 1.0204081632653061e-241], [-0.0, 0.0], [-1.5707963267948966, 5.357142857142857e-71, 2.6785714285714284e-71, 1.3392857142857142e-71, 6.696428571428571e-72]),
    ([1.0, 2e-170], [-2e-170, 1.0], [4e-170, -1.0], [2e-170, -1.4999999999999999e-170, 3.7499999999999997e-171, -9.374999999999999e-172, 2.3437499999999998e-172]),
    ([4e-160, -1.0], [1.0, 4e-160], [-8e-160, 1.0], [-1.5707963267948966, 3e-160, 1.5e-160, 7.5e-161, 3.75e-161]),
    ([0.0, 3e-200], [-3.3333333333333334e+199, 0.0], [0.0, f64::INFINITY], [1.5707963267948966, 0.0, 0.0, 0.0, 0.0]),
    ([0.0, -3e+250], [3.3333333333333336e-251, 0.0], [0.0, 0.0], [-1.5707963267948966, 0.0, 0.0, 0.0, 0.0]),
    ([2e-250, 0.0], [0.0, 5e+249], [0.0, f64::NEG_INFINITY], [0.0, 0.0, 0.0, 0.0, 0.0]),
    ([7e+160, 0.0], [0.0, 1.4285714285714285e-161], [0.0, -2.03e-322], [0.0, 0.0, 0.0, 0.0, 0.0]),
    ([2e-140, 3e-300], [-7.5e-21, 5e+139], [7.5e+119, -2.5e+279], [1.5000000000000003e-160, -1.125e-160, 2.8125e-161, -7.03125e-162, 1.7578125e-162]),
];
