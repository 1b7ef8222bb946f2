//! Generated models and regulators of every kind, against the references that were generated with them.

use std::collections::BTreeMap;
use std::path::Path;

use lagrangian_adversarial::{Comparison, MODELS, compare, compare_regulators};

#[test]
fn models_agree_with_an_independent_evaluation() {
    let comparisons = compare();
    // Without states nothing would be compared.
    assert!(comparisons.len() >= 12 * MODELS.len());
    check(&comparisons);
    check_conditioned(&comparisons);
    let of_motions = |c: &Comparison| MOTIONS.iter().any(|(kind, _)| kind_of(&c.model) == *kind);
    // Another file may have none.
    let motions = MOTIONS
        .iter()
        .filter(|_| comparisons.iter().any(of_motions));
    for (kind, least) in motions {
        let of_kind = |c: &&Comparison| kind_of(&c.model) == *kind;
        let count = comparisons.iter().filter(of_kind).count();
        assert!(count >= *least, "{count} comparisons of {kind}");
    }
}

/// The kinds whose motions are integrated, or that are steep, and how many comparisons there are of each at least.
const MOTIONS: &[(&str, usize)] = &[
    ("square_waves", 4),
    ("relays", 4),
    ("dry_friction", 4),
    ("signs_of_several", 4),
    ("steep", 20),
    ("steep_towers", 20),
    ("steep_motions", 4),
    ("turning_forms", 8),
    ("turning_angles", 8),
    ("turning_general", 8),
    ("turning_with_corners", 8),
    ("contacts_in_lanes", 2),
    ("kinks_in_lanes", 2),
    ("jumps_in_lanes", 2),
    ("watched_oscillators", 4),
    ("watched_falls", 4),
    ("watched_pendulums", 1),
    ("watched_pairs", 8),
];

/// The kind of a model: its identifier without its seed and number.
fn kind_of(model: &str) -> &str {
    let parts = model.rsplitn(3, '_');
    parts.last().unwrap_or_default()
}

#[test]
fn regulators_are_those_of_scipy() {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("models/regulators.json");
    let comparisons = compare_regulators(&file);
    assert!(comparisons.len() >= 2 * 48);
    check(&comparisons);
}

/// Fails unless q̈ and λ of models with constraints are within 10⁻¹⁵ times the number of unknowns times the condition number of their
/// equilibrated matrix, and within 10⁻¹¹ where this number is below 10³.
fn check_conditioned(comparisons: &[Comparison]) {
    let (mut worst, mut worst_of_regular, mut count) = (0.0_f64, 0.0_f64, 0);
    for comparison in comparisons {
        let Some(conditioning) = &comparison.conditioning else {
            continue;
        };
        count += 1;
        let error = conditioning.relative_error(comparison);
        let bound = 1e-15 * f64::from(conditioning.unknowns) * conditioning.condition;
        let Comparison {
            quantity,
            state,
            model,
            ..
        } = comparison;
        let at = format!("{quantity} at state {state} of {model}");
        assert!(error <= bound, "{error:e} exceeds {bound:e}: {at}");
        worst = worst.max(error / bound);
        if conditioning.condition < 1e3 {
            assert!(error <= 1e-11, "{error:e}: {at}");
            worst_of_regular = worst_of_regular.max(error);
        }
    }
    println!(
        "{count} q̈ and λ: {worst:.2} of 10⁻¹⁵ n cond at most, {worst_of_regular:.1e} where cond < 10³"
    );
    let is_constrained = |(id, _): &&(&str, _)| id.starts_with("constrained");
    let constrained = MODELS.iter().filter(is_constrained).count();
    assert!(count >= 3 * constrained, "{count} q̈ and λ");
}

/// Prints the worst comparison of each quantity, and fails if any is wrong.
fn check(comparisons: &[Comparison]) {
    let mut worst: BTreeMap<&str, &Comparison> = BTreeMap::new();
    let ratio = |c: &Comparison| {
        if c.is_within() {
            c.error() / c.tolerance.max(f64::MIN_POSITIVE)
        } else {
            f64::INFINITY
        }
    };
    for c in comparisons {
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
    for c in comparisons {
        assert_mutations_are_noticed(c);
    }
}

/// Fails unless the comparison would be wrong beside a reference of which one entry is off, is missing, or is one too many.
fn assert_mutations_are_noticed(comparison: &Comparison) {
    let beside = |expected: Vec<f64>| Comparison {
        expected,
        ..comparison.clone()
    };
    let expected = &comparison.expected;
    // Beyond twice the tolerance from what was found at most a tolerance away, and told apart in binary64.
    let distance = |x: f64| 2.1 * comparison.tolerance + 4.0 * f64::EPSILON * x.abs() + 1e-300;
    for (i, x) in expected.iter().enumerate() {
        for sign in [1.0, -1.0] {
            let mut off = expected.clone();
            off[i] += sign * distance(*x);
            let (quantity, model) = (&comparison.quantity, &comparison.model);
            assert!(
                !beside(off).is_within(),
                "entry {i} of {quantity} of {model}"
            );
        }
    }
    let fewer = expected[..expected.len().saturating_sub(1)].to_vec();
    assert!(expected.is_empty() || !beside(fewer).is_within());
    assert!(!beside([expected.as_slice(), &[0.0]].concat()).is_within());
}
