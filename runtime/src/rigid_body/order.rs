//! Comparison of single numbers, and lengths of vectors.

use nalgebra::Vector3;

use crate::integrate::SingleNumber;
use crate::linalg::largest;
use crate::scalar::Scalar;

/// Returns whether a < b, to the last digit of the scalar.
pub(crate) fn is_less<S: SingleNumber>(a: S, b: S) -> bool {
    (a - b).largest() < 0.0
}

/// Returns √(x² + y² + z²) without overflow or underflow.
pub(crate) fn length<S: Scalar>(vector: &Vector3<S>) -> S {
    let largest = largest(vector);
    if !(largest > 0.0 && largest.is_finite()) {
        return vector.iter().fold(S::zero(), |sum, x| sum + x.abs());
    }
    let size = S::from_f64(power_of_two_near(largest));
    let squares = vector.iter().map(|x| (*x / size) * (*x / size));
    size * squares.fold(S::zero(), |sum, x| sum + x).sqrt()
}

/// Returns a power of two of about the size of a positive number, so that division by it is exact.
pub(crate) fn power_of_two_near(positive: f64) -> f64 {
    let (_, exponent) = libm::frexp(positive);
    libm::ldexp(1.0, exponent.clamp(-1000, 1000))
}
