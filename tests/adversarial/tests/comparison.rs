//! That a comparison fails where it has to, and that data are read as they are written.

use lagrangian_adversarial::{At, Comparison, Conditioning, Values, compare_regulators};
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
        conditioning: None,
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
fn errors_are_relative_to_the_greatest_scaled_unknown() {
    let state = json!({
        "scales": "1.0 1.0 2.0", "condition": "10.0", "values": { "qdd": "1.0 2.0", "lambda": "6.0" },
    });
    let error = |quantity: &str, found: &[f64], expected: &[f64]| {
        let conditioning = Conditioning::of(&state, quantity).expect("scales");
        conditioning.relative_error(&comparison(found, expected))
    };
    // Of 1, 2 and 6/2 the greatest is 3.
    assert!((error("qdd", &[1.0, 2.5], &[1.0, 2.0]) - 0.5 / 3.0).abs() < 1e-15);
    assert!((error("lambda", &[6.6], &[6.0]) - 0.3 / 3.0).abs() < 1e-15);
    assert!(error("lambda", &[f64::NAN], &[6.0]).is_infinite());
    assert!(Conditioning::of(&state, "p").is_none());
}

#[test]
fn what_is_refused_is_not_right() {
    let refused = Comparison {
        found: Err("no solution".to_owned()),
        ..comparison(&[], &[])
    };
    assert!(!refused.is_within());
}

#[test]
fn a_reference_that_is_off_is_noticed() {
    // ẋ = x + u with the weights 1: P = K = 1 + √2.
    let problem = |gain: &str| {
        json!({ "regulators": [{
            "id": "one", "kind": "by hand", "discrete": false, "states": 2, "inputs": 1,
            "a": "1.0 0.0 0.0 -1.0", "b": "1.0 0.0", "q": "1.0 0.0 0.0 0.0", "r": "1.0",
            "cost": "2.414213562373095 0.0 0.0 0.0", "gain": gain,
            "tolerances": { "cost": "1e-13", "gain": "1e-13" },
        }] })
    };
    let file = std::env::temp_dir().join(format!("regulators_{}.json", std::process::id()));
    let are_within = |gain: &str| {
        std::fs::write(&file, problem(gain).to_string()).expect("a temporary file");
        let comparisons = compare_regulators(&file);
        comparisons.iter().all(Comparison::is_within)
    };
    let found = [
        "2.414213562373095 0.0",
        "2.4142135623733 0.0",
        "2.414213562373095 0.1",
    ]
    .map(are_within);
    std::fs::remove_file(&file).expect("the temporary file");
    assert_eq!(found, [true, false, false]);
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
