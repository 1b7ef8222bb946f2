//! Carlson's symmetric elliptic integrals.
//!
//! B. C. Carlson, *Numerical computation of real or complex elliptic integrals*, Numerical Algorithms **10** (1995)
//! 13–26: the duplication theorem makes the arguments nearly equal, then a Taylor polynomial is evaluated. The
//! polynomial is used where its error is the square of the machine epsilon, so that derivative parts are fully
//! accurate, too.
//!
//! `R_J` follows B. C. Carlson, *Computing elliptic integrals by duplication*, Numer. Math. **33** (1979) 1–16, in a
//! form without cancellation however small p is. A p that is much larger than the other arguments is first exchanged
//! for a small one, since each duplication would only reduce it to a quarter: NIST Digital Library of Mathematical
//! Functions, 19.21.12.

use crate::integrate::SingleNumber;
use crate::limits::elliptic::{DUPLICATIONS, LARGE_LAST};
use crate::linalg::largest;
use crate::scalar::Scalar;

/// Returns the ratio of the mean to the largest deviation of an argument from it at which a Taylor polynomial of this
/// degree has a relative error of the square of the machine epsilon.
fn nearness<S: Scalar>(constant: f64, degree: f64) -> f64 {
    let epsilon = S::machine_epsilon();
    libm::pow(constant * epsilon * epsilon, -1.0 / (degree + 1.0))
}

/// Returns whether more than `most` of the arguments are zero, so that the integral diverges.
fn diverges<S: Scalar>(arguments: &[S], most: usize) -> bool {
    let zeros = arguments.iter().filter(|x| x.abs().largest() <= 0.0);
    zeros.count() > most
}

fn infinity<S: Scalar>() -> S {
    S::from_f64(f64::INFINITY)
}

fn number<S: Scalar>(numerator: f64, denominator: f64) -> S {
    S::ratio(numerator, denominator)
}

/// Duplicates the arguments by their sums λ of products of roots until the mean is farther from 0 than the distances from it, and
/// returns the mean and the scale of what is left.
fn duplicated<S: SingleNumber, const K: usize>(
    mut arguments: [S; K],
    mut mean: S,
    mut distance: f64,
    mut lambda: impl FnMut(&[S; K], S) -> S,
) -> (S, S) {
    let quarter = S::from_f64(0.25);
    let mut scale = S::one();
    for _ in 0..DUPLICATIONS {
        if distance < mean.abs().largest() {
            break;
        }
        let lambda = lambda(&arguments, scale);
        arguments = arguments.map(|x| (x + lambda) * quarter);
        mean = (mean + lambda) * quarter;
        scale *= quarter;
        distance *= 0.25;
    }
    (mean, scale)
}

/// Returns `R_F`(x, y, z) = ½ ∫₀^∞ dt/√((t + x)(t + y)(t + z)), for nonnegative arguments; infinite if two are 0.
///
/// ```
/// use lagrangian::elliptic::carlson_rf;
///
/// // R_F(x, x, x) = 1/√x.
/// assert!((carlson_rf(4.0_f64, 4.0, 4.0) - 0.5).abs() < 1e-16);
/// ```
#[must_use]
pub fn carlson_rf<S: SingleNumber>(x: S, y: S, z: S) -> S {
    let start = [x, y, z];
    if diverges(&start, 1) {
        return infinity();
    }
    let mean = (x + y + z) * number(1.0, 3.0);
    let distance = nearness::<S>(3.0, 5.0) * largest(&start.map(|x| mean - x));
    let (a, scale) = duplicated(start, mean, distance, |arguments, _| {
        let [x, y, z] = arguments.map(Scalar::sqrt);
        x * y + x * z + y * z
    });
    let [x, y] = [start[0], start[1]].map(|x| (mean - x) * scale / a);
    let z = -(x + y);
    let e2 = x * y - z * z;
    let e3 = x * y * z;
    let series =
        S::one() - e2 * number(1.0, 10.0) + e3 * number(1.0, 14.0) + e2 * e2 * number(1.0, 24.0)
            - e2 * e3 * number(3.0, 44.0);
    series / a.sqrt()
}

/// Returns `R_C`(x, y) = `R_F`(x, y, y), for x ≥ 0 and y > 0: an inverse circular or hyperbolic tangent; infinite if y
/// is 0.
///
/// ```
/// use lagrangian::elliptic::carlson_rc;
///
/// // R_C(1, 2) = arctan 1.
/// assert!((carlson_rc(1.0_f64, 2.0) - core::f64::consts::FRAC_PI_4).abs() < 1e-16);
/// ```
#[must_use]
pub fn carlson_rc<S: SingleNumber>(x: S, y: S) -> S {
    if diverges(&[y], 0) {
        return infinity();
    }
    let mean = (x + y + y) * number(1.0, 3.0);
    let distance = nearness::<S>(3.0, 7.0) * largest(&[mean - x]);
    let (a, scale) = duplicated([x, y], mean, distance, |[x, y], _| {
        S::from_f64(2.0) * x.sqrt() * y.sqrt() + *y
    });
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

/// Returns `R_J`(x, y, z, p) = 3/2 ∫₀^∞ dt/((t + p)√((t + x)(t + y)(t + z))), for nonnegative x, y, z and p > 0.
///
/// It is infinite if two of x, y and z are 0, or if p is 0.
///
/// ```
/// use lagrangian::elliptic::carlson_rj;
///
/// // R_J(x, x, x, x) = x^(−3/2).
/// assert!((carlson_rj(4.0_f64, 4.0, 4.0, 4.0) - 0.125).abs() < 1e-16);
/// ```
#[must_use]
pub fn carlson_rj<S: SingleNumber>(x: S, y: S, z: S, p: S) -> S {
    if diverges(&[x, y, z], 1) || diverges(&[p], 0) {
        return infinity();
    }
    let is_large = p.largest() > LARGE_LAST * largest(&[x, y, z]);
    if is_large {
        with_large_last([x, y, z], p)
    } else {
        by_duplication([x, y, z, p])
    }
}

/// Computes `R_J` by duplication, with the square roots a, b, c and s of x, y, z and p.
fn by_duplication<S: SingleNumber>(start: [S; 4]) -> S {
    let [x, y, z, p] = start;
    let mean = (x + y + z + p + p) * number(1.0, 5.0);
    let distance = nearness::<S>(0.25, 5.0) * largest(&start.map(|x| mean - x));
    let mut sum = S::zero();
    let (a, scale) = duplicated(start, mean, distance, |arguments, scale| {
        let roots = arguments.map(Scalar::sqrt);
        let [x, y, z, _] = roots;
        let lambda = x * y + x * z + y * z;
        let (ratio, divisor) = elementary(arguments, &roots, arguments[3] + lambda);
        sum += scale / divisor * carlson_rc(S::one(), ratio);
        lambda
    });
    let [x, y, z] = [start[0], start[1], start[2]].map(|x| (mean - x) * scale / a);
    let six = S::from_f64(6.0);
    scale / a / a.sqrt() * third_kind_near_mean(x, y, z) + six * sum
}

/// Returns 1 + e and the divisor d = (s + a)(s + b)(s + c) of a duplication.
///
/// Let g = p + λ, α = p (a + b + c) + a b c and β = s g. Then the results are 2 β/(α + β) and α + β. Where products
/// would be beyond the range of numbers, α/β is computed as a sum of quotients.
fn elementary<S: SingleNumber>(arguments: &[S; 4], [a, b, c, s]: &[S; 4], g: S) -> (S, S) {
    let (a, b, c, s) = (*a, *b, *c, *s);
    let two = S::from_f64(2.0);
    let range = libm::sqrt(libm::cbrt(S::min_positive().largest()));
    let is_ordinary = |x: &S| (range..=1.0 / range).contains(&x.largest());
    if arguments.iter().all(is_ordinary) {
        let alpha = arguments[3] * (a + b + c) + a * b * c;
        let beta = s * g;
        let sum = alpha + beta;
        return (two * beta / sum, sum);
    }
    let sizes = [a, b, c].map(Scalar::largest);
    // Divides the largest root by s, and the product of the others by g, which is larger than this product.
    let product = if sizes[0] >= sizes[1] && sizes[0] >= sizes[2] {
        b * c / g * (a / s)
    } else if sizes[1] >= sizes[2] {
        a * c / g * (b / s)
    } else {
        a * b / g * (c / s)
    };
    let one_and_quotient = S::one() + s * (a + b + c) / g + product;
    (two / one_and_quotient, one_and_quotient * s * g)
}

/// Computes `R_J` where p is much larger than x, y and z.
///
/// With the least of these as x, (p − x) `R_J`(p) = 3 `R_F` − 3 `R_C`(yz/x, pq/x) − (q − x) `R_J`(q), where (p − x)(q −
/// x) = (y − x)(z − x), so that q lies between x and a small part of the others. `R_F` is larger than the other two
/// terms.
fn with_large_last<S: SingleNumber>([x, y, z]: [S; 3], p: S) -> S {
    let three = S::from_f64(3.0);
    let first = three * carlson_rf(x, y, z);
    let [x, y, z] = ascending([x, y, z]);
    let small = z.largest() / p.largest();
    let leading = first / (p - x);
    if libm::sqrt(small) < 0.25 * S::machine_epsilon() {
        return leading;
    }
    // In a unit in which products with the smallest numbers are still in range.
    let root = root_of_unit::<S>(z.largest());
    let [x, y, z, p] = [x, y, z, p].map(|x| x * root * root);
    let difference = (y - x) * ((z - x) / (p - x));
    let q = x + difference;
    if q.largest() <= 0.0 {
        return leading;
    }
    let elementary = three * x.sqrt() * carlson_rc(y * (z / p), q) / p.sqrt();
    let others = elementary + difference * by_duplication([x, y, z, q]);
    leading - others * root / (p - x) * root * root
}

/// Returns the square root of the power of four by which `size` is scaled to three fifths of the exponent range.
fn root_of_unit<S: SingleNumber>(size: f64) -> S {
    let exponent = |x: f64| libm::frexp(x).1;
    let target = exponent(S::min_positive().largest()) * -3 / 5;
    S::from_f64(libm::ldexp(1.0, (target - exponent(size)) / 2))
}

fn ascending<S: SingleNumber>([x, y, z]: [S; 3]) -> [S; 3] {
    let pair = |x: S, y: S| {
        if y.largest() < x.largest() {
            (y, x)
        } else {
            (x, y)
        }
    };
    let (x, y) = pair(x, y);
    let (y, z) = pair(y, z);
    let (x, y) = pair(x, y);
    [x, y, z]
}

/// Evaluates the Taylor polynomial of `R_J` in the relative distances of x, y and z from the mean.
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
