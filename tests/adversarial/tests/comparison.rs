//! That a comparison fails where it has to, and that data are read as they are written.

use lagrangian_adversarial::{At, Comparison, Values};
use nalgebra::SMatrix;
use serde_json::json;

fn comparison(found: &[f64], expected: &[f64]) -> Comparison {
    Comparison {
        model: String::new(),
        state: 0,
        quantity: "L".to_owned(),
        found: Ok(found.to_vec()),
        expected: expected.to_vec(),
        tolerance: 0.25,
    }
}

#[test]
fn the_worst_entry_counts() {
    assert!(comparison(&[1.0, -2.0], &[1.0, -2.25]).is_within());
    assert!(!comparison(&[1.0, 2.0], &[1.0, -2.0]).is_within());
    assert!(!comparison(&[1.5, -2.0], &[1.0, -2.0]).is_within());
}

#[test]
fn what_is_not_finite_is_wrong() {
    assert!(!comparison(&[f64::NAN], &[1.0]).is_within());
    assert!(!comparison(&[f64::INFINITY], &[f64::INFINITY]).is_within());
}

#[test]
fn lengths_must_agree() {
    assert!(!comparison(&[1.0], &[1.0, 2.0]).is_within());
    assert!(!comparison(&[1.0, 2.0], &[1.0]).is_within());
}

#[test]
fn what_is_refused_is_not_right() {
    let refused = Comparison {
        found: Err("no solution".to_owned()),
        ..comparison(&[], &[])
    };
    assert!(!refused.is_within());
}

fn at(params: &str) -> At {
    At::new(&json!({ "t": "0.5", "q": "1.0", "qd": "2.0", "params": params, "trial": "3.0" }))
}

#[test]
fn matrices_are_read_row_by_row() {
    let mut values = Values::of(&at("1.0 2.0 3.0 4.0 5.0"));
    assert!((values.number() - 1.0).abs() < 1e-15);
    let expected = SMatrix::<f64, 2, 2>::new(2.0, 3.0, 4.0, 5.0);
    assert!((values.matrix::<2, 2>() - expected).norm() < 1e-15);
}

#[test]
#[should_panic(expected = "`x` is no number")]
fn what_is_no_number_fails() {
    let _ = at("1.0 x");
}
