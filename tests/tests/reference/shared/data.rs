//! Numbers as they are read from the data.

use lagrangian_tests::{
    array, assert_close, list, number, numbers, public_case, public_cases, references,
};
use serde_json::json;

#[test]
fn decimals_are_read_to_the_nearest_number() {
    // 30 digits of the binary64 number nearest to a tenth.
    let tenth = number(&json!("1.00000000000000005551115123126e-01"));
    assert_eq!(tenth.to_bits(), 0.1_f64.to_bits());
    assert_eq!(number(&json!("28e-3")).to_bits(), 0.028_f64.to_bits());
}

#[test]
fn matrices_are_read_row_by_row() {
    let matrix = json!([["1", "2"], ["3", "4"]]);
    assert_close("a matrix", &numbers(&matrix), &[1.0, 2.0, 3.0, 4.0], 0.0);
    let named = json!({ "b": "2", "a": "1" });
    assert_close("numbers by name", &array::<2>(&named), &[1.0, 2.0], 0.0);
}

#[test]
#[should_panic(expected = "expected a decimal string, found null")]
fn what_is_missing_fails() {
    let _ = numbers(&json!({ "p": ["1"] })["q"]);
}

#[test]
#[should_panic(expected = "expected 3 numbers")]
fn a_wrong_length_fails() {
    let _ = array::<3>(&json!(["1", "2"]));
}

#[test]
fn all_cases_and_references_are_there() {
    assert_eq!(
        public_cases().len(),
        200_usize.div_ceil(public_case::STRIDE)
    );
    assert_eq!(list(&references()["references"]).len(), 63);
    assert_eq!(list(&references()["closed_forms"]).len(), 22);
}
