//! Prints every comparison as a line of JSON, for the generator to make tables of: those of the models, or of a file of regulators
//! that is named as the argument.

use std::path::Path;

use lagrangian_adversarial::{Comparison, compare_each, compare_regulators};
use serde_json::json;

fn main() {
    match std::env::args().nth(1) {
        Some(file) => compare_regulators(Path::new(&file))
            .into_iter()
            .for_each(print),
        None => compare_each(print),
    }
}

#[allow(clippy::needless_pass_by_value)] // It is handed over.
fn print(comparison: Comparison) {
    // What is not finite is no JSON, so numbers are printed as strings where they matter.
    let line = json!({
        "model": comparison.model,
        "state": comparison.state,
        "quantity": comparison.quantity,
        "error": comparison.error().to_string(),
        "tolerance": comparison.tolerance.to_string(),
        "refused": comparison.found.as_ref().err(),
        "found": format!("{:?}", comparison.found),
        "expected": format!("{:?}", comparison.expected),
    });
    println!("{line}");
}
