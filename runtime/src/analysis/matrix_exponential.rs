//! The exponential of a matrix, and its integral, by scaling and squaring.
//!
//! N. J. Higham, *The scaling and squaring method for the matrix exponential revisited*, SIAM J. Matrix Anal. Appl. **26**
//! (2005) 1179–1193, with the diagonal Padé approximant of degree 13. The integral is a block of the exponential of
//! (A, 1; 0, 0): C. F. Van Loan, *Computing integrals involving the matrix exponential*, IEEE Trans. Autom. Control **23**
//! (1978) 395–404; the other blocks are known, so that only this one is computed.

use nalgebra::SMatrix;

use crate::integrate::SingleNumber;
use crate::limits::analysis::{PADE_ERROR, PADE_SQUARINGS};
use crate::linalg::pivoting::{PivotedLu, solve};

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

/// exp(A h), and ∫ exp(A τ) dτ from 0 to h; not finite where A h is not or is so large that they overflow.
pub(super) fn exponential<S: SingleNumber, const D: usize>(
    matrix: &SMatrix<S, D, D>,
    period: S,
) -> [SMatrix<S, D, D>; 2] {
    let squarings = squarings(matrix, period);
    let step = period * S::from_f64(libm::ldexp(1.0, -squarings));
    let scaled = matrix * step;
    let [mut value, mut integral] = pade(&scaled, step);
    for _ in 0..squarings {
        // The integral over twice the time.
        integral += value * integral;
        value *= value;
    }
    [value, integral]
}

/// How often the argument has to be halved until the approximant has all digits.
fn squarings<S: SingleNumber, const D: usize>(matrix: &SMatrix<S, D, D>, period: S) -> i32 {
    let columns = (0..D).map(|j| {
        let column = matrix.column(j);
        column
            .iter()
            .map(|x| (*x * period).abs().largest())
            .sum::<f64>()
    });
    let norm = columns.fold(0.0, f64::max);
    let largest = libm::pow(S::machine_epsilon() / PADE_ERROR, 1.0 / 26.0);
    if norm > largest && norm.is_finite() {
        let (_, exponent) = libm::frexp(norm / largest);
        exponent.min(PADE_SQUARINGS)
    } else {
        0
    }
}

/// The approximants: with the odd part A W and the even part V of the numerator, exp A ≈ (V − A W)⁻¹ (V + A W), and the integral is
/// (V − A W)⁻¹ 2 W times the step.
fn pade<S: SingleNumber, const D: usize>(
    matrix: &SMatrix<S, D, D>,
    step: S,
) -> [SMatrix<S, D, D>; 2] {
    let unit = SMatrix::from_fn(|i, j| if i == j { S::one() } else { S::zero() });
    let second = matrix * matrix;
    let fourth = second * second;
    let sixth = fourth * second;
    let combined = |first: usize| {
        let b = |k: usize| S::from_f64(COEFFICIENTS[first + 2 * k]);
        let high = sixth * (sixth * b(6) + fourth * b(5) + second * b(4));
        high + sixth * b(3) + fourth * b(2) + second * b(1) + unit * b(0)
    };
    let (even, without_factor) = (combined(0), combined(1));
    let odd = matrix * without_factor;
    let factored = PivotedLu::new(even - odd);
    let PivotedLu {
        factors,
        reciprocals,
        interchanges,
    } = &factored;
    let solved = |right: &SMatrix<S, D, D>| solve(factors, reciprocals, interchanges, right);
    let doubled = without_factor * (step + step);
    [solved(&(even + odd)), solved(&doubled)]
}
