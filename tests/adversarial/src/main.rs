//! Prints every comparison as a line of JSON, for the generator to make tables of.

use lagrangian_adversarial::compare;
use serde_json::json;

fn main() {
    for comparison in compare() {
        // What is not finite is no JSON, so numbers are printed as strings where they matter.
        let line = json!({
            "model": comparison.model,
            "state": comparison.state,
            "quantity": comparison.quantity,
            "error": comparison.error().to_string(),
            "tolerance": comparison.tolerance.to_string(),
            "found": format!("{:?}", comparison.found),
            "expected": format!("{:?}", comparison.expected),
        });
        println!("{line}");
    }
}
