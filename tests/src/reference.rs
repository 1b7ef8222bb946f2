//! The reference values in `data/`.

use std::{fs, path::Path};

use serde_json::Value;

/// The random Lagrangians of which there are models, in the order of `public_cases!`: all 200 with the feature `all-cases`,
/// and otherwise one of nine.
///
/// # Panics
///
/// If the file cannot be read.
#[must_use]
pub fn public_cases() -> Vec<Value> {
    let document = document("public_cases.json");
    let cases = list(&document["cases"]).iter();
    cases.step_by(crate::public_case::STRIDE).cloned().collect()
}

/// The document with `references` (trajectories) and `closed_forms`.
///
/// # Panics
///
/// If the file cannot be read.
#[must_use]
pub fn references() -> Value {
    document("references_public.json")
}

/// The accelerations of tops near the poles.
///
/// # Panics
///
/// If the file cannot be read.
#[must_use]
pub fn near_the_poles() -> Value {
    document("near_the_poles.json")
}

/// Linear systems with their regulators and discretizations.
///
/// # Panics
///
/// If the file cannot be read.
#[must_use]
pub fn linear_control() -> Value {
    document("linear_control.json")
}

/// Regulators of badly scaled problems.
#[must_use]
pub fn regulators() -> Value {
    document("regulators.json")
}

/// The motion of a snakeboard.
#[must_use]
pub fn snakeboard() -> Value {
    document("snakeboard.json")
}

/// The motion of a flyball governor.
#[must_use]
pub fn governor() -> Value {
    document("governor.json")
}

/// The motion of Bricard's mechanism with six revolute joints.
#[must_use]
pub fn bricard() -> Value {
    document("bricard.json")
}

/// The published linear equations of a bicycle.
#[must_use]
pub fn bicycle() -> Value {
    document("bicycle.json")
}

fn document(name: &str) -> Value {
    let path = Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("data")
        .join(name);
    let text =
        fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
    serde_json::from_str(&text).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

/// A list of the data.
///
/// # Panics
///
/// If it is none.
#[must_use]
pub fn list(value: &Value) -> &[Value] {
    value
        .as_array()
        .unwrap_or_else(|| panic!("expected a list, found {value}"))
}

/// A string of the data.
///
/// # Panics
///
/// If it is none.
#[must_use]
pub fn text(value: &Value) -> &str {
    value
        .as_str()
        .unwrap_or_else(|| panic!("expected a string, found {value}"))
}

/// A number of the data: a decimal string, read as the nearest binary64.
///
/// # Panics
///
/// If it is none.
#[must_use]
pub fn number(value: &Value) -> f64 {
    let decimal = value.as_str().and_then(|text| text.parse().ok());
    decimal.unwrap_or_else(|| panic!("expected a decimal string, found {value}"))
}

/// The numbers of a scalar, of a vector, or of a matrix row by row; of an object in the order of
/// its keys.
///
/// # Panics
///
/// If something else stands among them.
#[must_use]
pub fn numbers(value: &Value) -> Vec<f64> {
    match value {
        Value::Array(entries) => entries.iter().flat_map(numbers).collect(),
        Value::Object(entries) => entries.values().flat_map(numbers).collect(),
        scalar => vec![number(scalar)],
    }
}

/// The `N` numbers of a vector.
///
/// # Panics
///
/// If there are more or fewer.
#[must_use]
pub fn array<const N: usize>(value: &Value) -> [f64; N] {
    numbers(value)
        .try_into()
        .unwrap_or_else(|_| panic!("expected {N} numbers, found {value}"))
}
