//! Powers of numbers beyond the range of numbers are refused at once, with a sentence; all others are derived.

use crate::expand::expand;

/// What is emitted for a particle in this potential.
fn expanded(potential: &str) -> String {
    let text = format!(
        "#[lagrangian(coordinates(x), kinetic = 0.5 * dot(x).powi(2), potential = {potential})] struct P {{ k: f64 }}"
    );
    expand(text.parse().unwrap()).to_string()
}

#[test]
fn powers_beyond_the_range_of_numbers_are_refused() {
    for potential in [
        "2.0.powi(100000) * x",
        "2.0.powi(2000000000) * x",
        "0.5.powi(100000) * x",
        "10.0.powi(-400) * x",
        "10.0.powi(309) * x",
        "(10.0.powi(200)).powi(200) * x",
        "2.0.powf(100000.0) * x",
        "10.0.powf(-400.5) * x",
        "(-3.0).powi(100001) * x",
        "PI * 7.0.powi(1000) * x",
    ] {
        let found = expanded(potential);
        assert!(
            found.contains("is outside of the range of `f64`"),
            "{potential}"
        );
    }
}

#[test]
fn other_powers_are_derived() {
    for potential in [
        "1.0001.powi(100000) * x",
        "1.0.powi(2000000000) * x",
        "(-1.0).powi(2000000001) * x",
        "0.999.powi(100000) * x",
        "2.0.powi(1000) * x",
        "10.0.powi(-300) * x",
        "x.powi(100000)",
        "(k * x).powi(-2000000000)",
        "x.powf(100000.5)",
        "((x.powi(1000)).powi(1000)).powi(1000)",
    ] {
        let found = expanded(potential);
        assert!(!found.contains("compile_error"), "{potential}: {found}");
    }
}
