//! One way to compare.

use lagrangian::VectorSpace;

/// The largest of |aᵢ − bᵢ|, each relative to 1 or |bᵢ|; infinite where one is not finite.
pub(crate) fn error(found: &[f64], expected: &[f64]) -> f64 {
    assert_eq!(found.len(), expected.len());
    let errors = found
        .iter()
        .zip(expected)
        .map(|(a, b)| (a - b).abs() / b.abs().max(1.0));
    errors.fold(0.0, |most, error| {
        if error <= most {
            most
        } else if error.is_nan() {
            f64::INFINITY
        } else {
            error
        }
    })
}

/// Fails unless all components of two states are close.
#[track_caller]
pub(crate) fn assert_close<X: VectorSpace<f64>>(found: &X, expected: &X, tolerance: f64) {
    let found: Vec<f64> = found.components().collect();
    let expected: Vec<f64> = expected.components().collect();
    let error = error(&found, &expected);
    assert!(
        error <= tolerance,
        "{found:?} is not {expected:?}: the error is {error:e}, the tolerance {tolerance:e}"
    );
}

#[test]
fn errors_are_seen() {
    assert_eq!(error(&[1.0, -2.0], &[1.0, -4.0]), 0.5);
    assert_eq!(error(&[0.0, 0.25], &[0.5, 0.25]), 0.5);
    assert_eq!(error(&[f64::NAN, 0.0], &[0.0, 0.0]), f64::INFINITY);
}
