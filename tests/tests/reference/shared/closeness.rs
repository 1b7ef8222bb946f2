//! Relative errors, and the comparison that fails.

use lagrangian_tests::{assert_close, relative_error};

#[test]
fn what_agrees_has_no_error() {
    assert!(relative_error(&[1.0, -2.0], &[1.0, -2.0], 1.0) <= 0.0);
    assert!(relative_error(&[], &[], 1.0) <= 0.0);
}

#[test]
fn too_little_is_as_wrong_as_too_much() {
    for found in [0.75, 1.25, -1.25, -0.75] {
        let expected = f64::signum(found);
        assert!((relative_error(&[found], &[expected], 0.5) - 0.25).abs() < 1e-15);
    }
}

#[test]
fn the_worst_entry_counts_in_relation_to_the_greatest() {
    let error = relative_error(&[3.0, -4.0, 0.5], &[3.0, -4.0, -0.5], 1e-3);
    assert!((error - 0.25).abs() < 1e-15);
}

#[test]
fn below_the_floor_the_floor_counts() {
    assert!((relative_error(&[1e-6], &[0.0], 1e-3) - 1e-3).abs() < 1e-15);
    assert!((relative_error(&[0.0], &[-1e-6], 1e-3) - 1e-3).abs() < 1e-15);
}

#[test]
fn what_is_not_finite_is_infinitely_wrong() {
    for odd in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        assert!(relative_error(&[1.0, odd], &[1.0, odd], 1.0) == f64::INFINITY);
        assert!(relative_error(&[odd, 1.0], &[1.0, 1.0], 1.0) == f64::INFINITY);
        assert!(relative_error(&[1.0, 1.0], &[1.0, odd], 1.0) == f64::INFINITY);
    }
}

#[test]
#[should_panic(expected = "lengths differ")]
fn lengths_must_agree() {
    let _ = relative_error(&[1.0], &[1.0, 1.0], 1.0);
}

#[test]
#[should_panic(expected = "the error is 2.5e-1")]
fn what_is_too_small_fails() {
    assert_close("a number", &[0.75], &[1.0], 0.2);
}

#[test]
#[should_panic(expected = "the error is inf")]
fn what_is_no_number_fails() {
    assert_close("a number", &[f64::NAN], &[1.0], f64::MAX);
}
