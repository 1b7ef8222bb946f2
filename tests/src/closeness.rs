//! The one way in which numbers are compared.

/// The greatest distance between two entries, relative to the greatest entry of what is expected,
/// or to `floor` if that is greater. It is infinite if anything is not finite, and so never small
/// by accident.
///
/// # Panics
///
/// If the lengths differ, or if `floor` is not positive.
#[must_use]
pub fn relative_error(found: &[f64], expected: &[f64], floor: f64) -> f64 {
    assert_eq!(found.len(), expected.len(), "lengths differ");
    assert!(floor > 0.0, "the floor {floor} is not positive");
    if found.iter().chain(expected).any(|entry| !entry.is_finite()) {
        return f64::INFINITY;
    }
    let greatest = |entries: &mut dyn Iterator<Item = f64>| entries.fold(0.0, f64::max);
    let distance = greatest(
        &mut found
            .iter()
            .zip(expected)
            .map(|(found, expected)| (found - expected).abs()),
    );
    let scale = greatest(&mut expected.iter().map(|expected| expected.abs()));
    distance / scale.max(floor)
}

/// Panics unless the relative error, with the floor 1, is at most the tolerance.
///
/// # Panics
///
/// That is its purpose.
#[track_caller]
pub fn assert_close(what: &str, found: &[f64], expected: &[f64], tolerance: f64) {
    let error = relative_error(found, expected, 1.0);
    assert!(
        error <= tolerance,
        "{what}: {found:?} is not {expected:?}; the error is {error:e}, the tolerance {tolerance:e}"
    );
}
