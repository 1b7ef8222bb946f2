//! Regulators beside those that SciPy finds, and that were refined in more digits.

use std::path::Path;

use lagrangian_adversarial::compare_regulators;

#[test]
fn regulators_are_those_of_scipy() {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("models/regulators.json");
    let comparisons = compare_regulators(&file);
    assert!(comparisons.len() >= 2 * 40);
    let wrong: Vec<_> = comparisons.iter().filter(|c| !c.is_within()).collect();
    for c in &wrong {
        println!(
            "{} of {}: {:?} is not {:?}, to {:e}",
            c.quantity, c.model, c.found, c.expected, c.tolerance
        );
    }
    assert!(
        wrong.is_empty(),
        "{} of {} are wrong",
        wrong.len(),
        comparisons.len()
    );
}
