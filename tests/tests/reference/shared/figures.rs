//! Tables of the greatest errors.

use lagrangian_tests::Figures;

#[test]
fn the_worst_error_is_kept_with_its_place() {
    let mut figures = Figures::new();
    figures.record("q", "first", 1e-3, 1.0);
    figures.record("q", "second", 2e-3, 1.0);
    figures.record("q", "third", 1e-4, 1.0);
    assert!(
        figures
            .to_string()
            .ends_with("3    2.0e-3      1.0e0  second\n"),
        "{figures}"
    );
    figures.finish();
}

#[test]
fn the_worst_error_is_the_one_nearest_to_its_tolerance() {
    let mut figures = Figures::new();
    figures.record("q", "first", 1e-3, 1.0);
    figures.record("q", "second", 1e-4, 1e-2);
    assert!(
        figures
            .to_string()
            .ends_with("2    1.0e-4     1.0e-2  second\n"),
        "{figures}"
    );
    figures.finish();
}

#[test]
#[should_panic(expected = "1 errors:\nq at second: error 2.00e-3, tolerance 1.0e-3")]
fn an_error_above_its_tolerance_fails() {
    let mut figures = Figures::new();
    figures.record("q", "first", 1e-3, 1e-3);
    figures.record("q", "second", 2e-3, 1e-3);
    figures.record("q", "third", 1e-4, 1e-3);
    figures.finish();
}

#[test]
#[should_panic(expected = "q at first: error NaN")]
fn what_is_no_number_fails() {
    let mut figures = Figures::new();
    figures.record("q", "first", f64::NAN, f64::MAX);
    figures.record("q", "second", 0.0, f64::MAX);
    figures.finish();
}

#[test]
#[should_panic(expected = "nothing was compared")]
fn no_comparison_fails() {
    Figures::new().finish();
}
