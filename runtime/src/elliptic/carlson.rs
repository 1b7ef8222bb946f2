//! Carlson's symmetric elliptic integrals.
//!
//! B. C. Carlson, *Numerical computation of real or complex elliptic integrals*, Numerical Algorithms **10** (1995) 13–26:
//! the duplication theorem makes the arguments nearly equal, and a Taylor polynomial does the rest. The polynomial is
//! used where its error is the square of the machine epsilon, so that derivative parts have all digits, too.

use crate::integrate::SingleNumber;
use crate::limits::elliptic::DUPLICATIONS;
use crate::scalar::Scalar;

/// By what factor the arguments have to be nearer to their mean than they are, for a relative error of the square of
/// the machine epsilon of a polynomial of this degree.
fn nearness<S: Scalar>(constant: f64, degree: f64) -> f64 {
    let epsilon = S::machine_epsilon();
    libm::pow(constant * epsilon * epsilon, -1.0 / (degree + 1.0))
}

/// The largest magnitude of numbers.
fn largest<S: Scalar>(numbers: &[S]) -> f64 {
    numbers
        .iter()
        .fold(0.0, |most: f64, x| most.max(x.abs().largest()))
}

fn number<S: Scalar>(numerator: f64, denominator: f64) -> S {
    S::ratio(numerator, denominator)
}

/// `R_F`(x, y, z) = ½ ∫₀^∞ dt/√((t + x)(t + y)(t + z)), for arguments that are not negative, at most one of them 0.
///
/// ```
/// use lagrangian::elliptic::carlson_rf;
///
/// // R_F(x, x, x) = 1/√x.
/// assert!((carlson_rf(4.0_f64, 4.0, 4.0) - 0.5).abs() < 1e-16);
/// ```
#[must_use]
pub fn carlson_rf<S: SingleNumber>(x: S, y: S, z: S) -> S {
    let mean = (x + y + z) * number(1.0, 3.0);
    let start = [x, y, z];
    let mut distance = nearness::<S>(3.0, 5.0) * largest(&start.map(|x| mean - x));
    let quarter = S::from_f64(0.25);
    let (mut arguments, mut a, mut scale) = (start, mean, S::one());
    for _ in 0..DUPLICATIONS {
        if distance < a.abs().largest() {
            break;
        }
        let [x, y, z] = arguments.map(Scalar::sqrt);
        let lambda = x * y + x * z + y * z;
        arguments = arguments.map(|x| (x + lambda) * quarter);
        a = (a + lambda) * quarter;
        scale *= quarter;
        distance *= 0.25;
    }
    let [x, y] = [start[0], start[1]].map(|x| (mean - x) * scale / a);
    let z = -(x + y);
    let e2 = x * y - z * z;
    let e3 = x * y * z;
    let series =
        S::one() - e2 * number(1.0, 10.0) + e3 * number(1.0, 14.0) + e2 * e2 * number(1.0, 24.0)
            - e2 * e3 * number(3.0, 44.0);
    series / a.sqrt()
}

/// `R_C`(x, y) = `R_F`(x, y, y), for x ≥ 0 and y > 0: an inverse circular or hyperbolic tangent.
///
/// ```
/// use lagrangian::elliptic::carlson_rc;
///
/// // R_C(1, 2) = arctan 1.
/// assert!((carlson_rc(1.0_f64, 2.0) - core::f64::consts::FRAC_PI_4).abs() < 1e-16);
/// ```
#[must_use]
pub fn carlson_rc<S: SingleNumber>(x: S, y: S) -> S {
    let mean = (x + y + y) * number(1.0, 3.0);
    let mut distance = nearness::<S>(3.0, 7.0) * largest(&[mean - x]);
    let quarter = S::from_f64(0.25);
    let (mut at, mut a, mut scale) = ([x, y], mean, S::one());
    for _ in 0..DUPLICATIONS {
        if distance < a.abs().largest() {
            break;
        }
        let [x, y] = at;
        let lambda = S::from_f64(2.0) * x.sqrt() * y.sqrt() + y;
        at = at.map(|x| (x + lambda) * quarter);
        a = (a + lambda) * quarter;
        scale *= quarter;
        distance *= 0.25;
    }
    let s = (y - mean) * scale / a;
    let coefficients = [
        (9.0, 8.0),
        (159.0, 208.0),
        (9.0, 22.0),
        (3.0, 8.0),
        (1.0, 7.0),
        (3.0, 10.0),
    ];
    let series = coefficients
        .into_iter()
        .fold(S::zero(), |sum, (n, d)| sum * s + number(n, d));
    (S::one() + s * s * series) / a.sqrt()
}

/// `R_J`(x, y, z, p) = 3/2 ∫₀^∞ dt/((t + p)√((t + x)(t + y)(t + z))), for x, y, z that are not negative, at most one of them
/// 0, and p > 0.
///
/// ```
/// use lagrangian::elliptic::carlson_rj;
///
/// // R_J(x, x, x, x) = x^(−3/2).
/// assert!((carlson_rj(4.0_f64, 4.0, 4.0, 4.0) - 0.125).abs() < 1e-16);
/// ```
#[must_use]
pub fn carlson_rj<S: SingleNumber>(x: S, y: S, z: S, p: S) -> S {
    let mean = (x + y + z + p + p) * number(1.0, 5.0);
    let start = [x, y, z, p];
    let mut distance = nearness::<S>(0.25, 5.0) * largest(&start.map(|x| mean - x));
    let mut delta = (p - x) * (p - y) * (p - z);
    let quarter = S::from_f64(0.25);
    let (mut arguments, mut a, mut scale, mut sum) = (start, mean, S::one(), S::zero());
    for _ in 0..DUPLICATIONS {
        if distance < a.abs().largest() {
            break;
        }
        let [x, y, z, p] = arguments.map(Scalar::sqrt);
        let lambda = x * y + x * z + y * z;
        let d = (p + x) * (p + y) * (p + z);
        let e = delta / (d * d);
        sum += scale / d * carlson_rc(S::one(), S::one() + e);
        arguments = arguments.map(|x| (x + lambda) * quarter);
        a = (a + lambda) * quarter;
        scale *= quarter;
        delta *= S::from_f64(1.0 / 64.0);
        distance *= 0.25;
    }
    let [x, y, z] = [start[0], start[1], start[2]].map(|x| (mean - x) * scale / a);
    let six = S::from_f64(6.0);
    scale * third_kind_near_mean(x, y, z) / (a * a.sqrt()) + six * sum
}

/// The Taylor polynomial of `R_J` in the distances of x, y and z from the mean, relative to it.
fn third_kind_near_mean<S: Scalar>(x: S, y: S, z: S) -> S {
    let p = -(x + y + z) * S::from_f64(0.5);
    let xyz = x * y * z;
    let [two, three, four] = [2.0, 3.0, 4.0].map(S::from_f64);
    let e2 = x * y + x * z + y * z - three * p * p;
    let e3 = xyz + two * e2 * p + four * p * p * p;
    let e4 = (two * xyz + e2 * p + three * p * p * p) * p;
    let e5 = xyz * p * p;
    S::one() - e2 * number(3.0, 14.0) + e3 * number(1.0, 6.0) + e2 * e2 * number(9.0, 88.0)
        - e4 * number(3.0, 22.0)
        - e2 * e3 * number(9.0, 52.0)
        + e5 * number(3.0, 26.0)
}
