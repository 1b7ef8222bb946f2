//! Generated models of every kind, against the references that were generated with them.

use std::collections::BTreeMap;

use lagrangian_adversarial::{Comparison, MODELS, compare};

#[test]
fn models_agree_with_an_independent_evaluation() {
    let comparisons = compare();
    // Without states nothing would be compared.
    assert!(comparisons.len() >= 12 * MODELS.len());
    let mut worst: BTreeMap<&str, &Comparison> = BTreeMap::new();
    let ratio = |c: &Comparison| {
        if c.is_within() {
            c.error() / c.tolerance.max(f64::MIN_POSITIVE)
        } else {
            f64::INFINITY
        }
    };
    for c in &comparisons {
        let row = worst.entry(&c.quantity).or_insert(c);
        if ratio(c) > ratio(row) {
            *row = c;
        }
    }
    for (quantity, c) in worst {
        println!(
            "{quantity:20} {:9.2e} of {:9.2e}  {}, state {}",
            c.error(),
            c.tolerance,
            c.model,
            c.state
        );
    }
    let wrong: Vec<String> = comparisons
        .iter()
        .filter(|c| !c.is_within())
        .map(|c| {
            format!(
                "{} at state {} of {}: {:?} is not {:?}",
                c.quantity, c.state, c.model, c.found, c.expected
            )
        })
        .collect();
    assert!(
        wrong.is_empty(),
        "{} errors:\n{}",
        wrong.len(),
        wrong.join("\n")
    );
}
