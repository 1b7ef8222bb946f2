//! The exponential of a matrix, and its integral, by scaling and squaring.
//!
//! The scaling follows A. H. Al-Mohy and N. J. Higham, *A new scaling and squaring algorithm for the matrix
//! exponential*, SIAM J. Matrix Anal. Appl. **31** (2009) 970–989. It uses roots of norms of powers, which are much
//! less than the norm if the matrix is far from normal, and 0 if it is nilpotent. Groups of uncoupled variables are
//! treated separately, so that a stiff group does not cost a soft one its accuracy, and are balanced (Parlett and
//! Reinsch).
//!
//! The diagonal Padé approximant of degree 13: N. J. Higham, *The scaling and squaring method for the matrix
//! exponential revisited*, SIAM J. Matrix Anal. Appl. **26** (2005) 1179–1193. The integral is a block of the
//! exponential of (A, 1; 0, 0): C. F. Van Loan, *Computing integrals involving the matrix exponential*, IEEE Trans.
//! Autom. Control **23** (1978) 395–404. The other blocks are known, so that only this one is computed.

use nalgebra::{SMatrix, SVector};

use super::components::components;
use super::eigenvalues::balancing;
use crate::integrate::SingleNumber;
use crate::limits::analysis::{PADE_ERROR, PADE_SQUARINGS};
use crate::linalg::kept;
use crate::linalg::pivoting::PivotedLu;
use crate::scalar::Scalar;

/// The coefficients of the numerator of the Padé approximant of degree 13, exactly.
const COEFFICIENTS: [f64; 14] = [
    64_764_752_532_480_000.0,
    32_382_376_266_240_000.0,
    7_771_770_303_897_600.0,
    1_187_353_796_428_800.0,
    129_060_195_264_000.0,
    10_559_470_521_600.0,
    670_442_572_800.0,
    33_522_128_640.0,
    1_323_241_920.0,
    40_840_800.0,
    960_960.0,
    16_380.0,
    182.0,
    1.0,
];

/// The least root of the norm of a power relative to the norm; a smaller root may be due to underflow.
const MIN_ROOT: f64 = 1e-28;

/// Returns exp(A h), and ∫ exp(A τ) dτ from 0 to h; they are not finite if A h is not, or if they overflow.
pub(super) fn exponential<S: SingleNumber, const D: usize>(
    matrix: &SMatrix<S, D, D>,
    period: S,
) -> [SMatrix<S, D, D>; 2] {
    let labels = components(&[matrix]);
    let mut sums = [SMatrix::<S, D, D>::zeros(); 2];
    for label in (0..D).filter(|i| labels[*i] == *i) {
        let is_member = |i: usize, j: usize| labels[i] == label && labels[j] == label;
        let part = kept(matrix, is_member);
        let found = of_component(&part, period);
        for (sum, part) in sums.iter_mut().zip(&found) {
            for i in 0..D {
                for j in (0..D).filter(|j| is_member(i, *j)) {
                    sum[(i, j)] = part[(i, j)];
                }
            }
        }
    }
    sums
}

/// Returns the exponential and its integral for a group of coupled variables.
fn of_component<S: SingleNumber, const D: usize>(
    matrix: &SMatrix<S, D, D>,
    period: S,
) -> [SMatrix<S, D, D>; 2] {
    let exponents = balancing(&matrix.map(Scalar::largest));
    // D⁻¹ A D, or its inverse transformation.
    let in_units = |matrix: SMatrix<S, D, D>, sign: i32| {
        SMatrix::<S, D, D>::from_fn(|i, j| {
            let exponent = sign * (exponents[j] - exponents[i]);
            matrix[(i, j)] * S::from_f64(libm::ldexp(1.0, exponent))
        })
    };
    let balanced = in_units(*matrix, 1);
    let squarings = squarings(&balanced, period);
    let step = period * S::from_f64(libm::ldexp(1.0, -squarings));
    let [mut value, mut integral] = pade(&(balanced * step), step);
    for _ in 0..squarings {
        // Doubles the time of the integral.
        integral += value * integral;
        value *= value;
    }
    [in_units(value, -1), in_units(integral, -1)]
}

/// Returns the number of halvings after which the approximant is accurate to all digits: the parameters s and ℓ of
/// algorithm 5.1 of Al-Mohy and Higham.
fn squarings<S: SingleNumber, const D: usize>(matrix: &SMatrix<S, D, D>, period: S) -> i32 {
    let argument = matrix.map(|x| (x * period).largest());
    let norm = norm(&argument);
    let epsilon = S::machine_epsilon();
    let largest = libm::pow(epsilon / PADE_ERROR, 1.0 / 26.0);
    if norm.is_nan() || norm <= largest || norm.is_infinite() {
        return 0;
    }
    // Powers of a matrix of norm 1 do not overflow.
    let unit = argument / norm;
    let halvings = halvings(root_of_powers(&unit) * norm / largest);
    // The backward error at this scale is bounded by the matrix of the magnitudes.
    let mut row = SVector::<f64, D>::repeat(1.0);
    let magnitudes = unit.abs();
    for _ in 0..27 {
        row = magnitudes.tr_mul(&row);
    }
    let scaled = norm * libm::ldexp(1.0, -halvings);
    let error = libm::log2(PADE_ERROR / epsilon) + libm::log2(row.amax());
    let excess = error / 26.0 + libm::log2(scaled);
    (halvings + ceiling(excess)).min(PADE_SQUARINGS)
}

/// Returns min(max(d₆, d₈), max(d₈, d₁₀)) with dₖ = ‖Aᵏ‖^(1/k), for a matrix of norm 1.
fn root_of_powers<const D: usize>(unit: &SMatrix<f64, D, D>) -> f64 {
    let second = unit * unit;
    let fourth = second * second;
    let eighth = fourth * fourth;
    let root = |power: SMatrix<f64, D, D>, k: f64| libm::pow(norm(&power), 1.0 / k);
    let [sixth, eighth, tenth] = [
        root(fourth * second, 6.0),
        root(eighth, 8.0),
        root(eighth * second, 10.0),
    ];
    sixth.max(eighth).min(eighth.max(tenth)).max(MIN_ROOT)
}

/// Returns how often a number has to be halved to be at most 1.
fn halvings(x: f64) -> i32 {
    ceiling(libm::log2(x))
}

/// Returns the least integer that is not less than x, or 0 if this is negative.
#[allow(clippy::cast_possible_truncation)] // It is between 0 and the limit.
fn ceiling(x: f64) -> i32 {
    libm::ceil(x).clamp(0.0, f64::from(PADE_SQUARINGS)) as i32
}

/// Returns the 1-norm, the largest column sum of magnitudes.
fn norm<const D: usize>(matrix: &SMatrix<f64, D, D>) -> f64 {
    let columns = (0..D).map(|j| matrix.column(j).iter().map(|x| x.abs()).sum::<f64>());
    columns.fold(0.0, |most, sum| if sum <= most { most } else { sum })
}

/// Returns the Padé approximants of the exponential and its integral.
///
/// With the odd part A W and the even part V of the numerator, exp A ≈ (V − A W)⁻¹ (V + A W), and the integral is (V −
/// A W)⁻¹ 2 W times the step.
fn pade<S: SingleNumber, const D: usize>(
    matrix: &SMatrix<S, D, D>,
    step: S,
) -> [SMatrix<S, D, D>; 2] {
    let unit = SMatrix::from_fn(|i, j| if i == j { S::one() } else { S::zero() });
    let second = matrix * matrix;
    let fourth = second * second;
    let sixth = fourth * second;
    let combined = |first: usize| {
        // Relative to the leading coefficient, so that the exponential of a nilpotent matrix is exact.
        let leading = S::from_f64(COEFFICIENTS[0]);
        let b = |k: usize| S::from_f64(COEFFICIENTS[first + 2 * k]) / leading;
        let high = sixth * (sixth * b(6) + fourth * b(5) + second * b(4));
        high + sixth * b(3) + fourth * b(2) + second * b(1) + unit * b(0)
    };
    let (even, without_factor) = (combined(0), combined(1));
    let odd = matrix * without_factor;
    let factored = PivotedLu::new(even - odd);
    let doubled = without_factor * (step + step);
    [factored.solve(&(even + odd)), factored.solve(&doubled)]
}
