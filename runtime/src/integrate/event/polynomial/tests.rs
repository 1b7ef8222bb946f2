//! Tests of the roots of polynomials that are built from their roots.

use super::{Polynomial, Root};
use crate::scalar::DoubleDouble;

/// Returns the product of c and (u − r) for each root r, computed to all digits and rounded to 16 digits.
fn with_roots(c: f64, roots: &[f64]) -> Polynomial {
    let mut coefficients = vec![DoubleDouble::from(c)];
    for root in roots {
        let root = DoubleDouble::from(*root);
        coefficients.insert(0, DoubleDouble::from(0.0));
        for k in 0..coefficients.len() - 1 {
            coefficients[k] = coefficients[k] - root * coefficients[k + 1];
        }
    }
    let rounded = coefficients.iter().map(|a| DoubleDouble::from(a.to_f64()));
    Polynomial::new(rounded, f64::EPSILON).unwrap()
}

fn roots(polynomial: &Polynomial) -> Vec<Root> {
    let (mut from, mut sign) = (0.0, 0.0);
    let mut roots: Vec<Root> = Vec::new();
    while let Some(root) = polynomial.next_root(from, sign) {
        assert!(
            roots
                .last()
                .is_none_or(|last| last.behind * root.before > 0.0)
        );
        assert!(root.until > from && root.until >= root.at);
        (from, sign) = (root.until, root.behind);
        roots.push(root);
        assert!(roots.len() < 100, "{roots:?}");
    }
    roots
}

/// Returns a number between 0 and 1 (a linear congruential generator of Knuth, *The Art of Computer Programming*
/// **2**).
fn random(state: &mut u64) -> f64 {
    *state = state
        .wrapping_mul(6_364_136_223_846_793_005)
        .wrapping_add(1_442_695_040_888_963_407);
    f64::from(u32::try_from(*state >> 32).unwrap()) / f64::from(u32::MAX)
}

#[test]
fn two_roots_next_to_each_other_are_found_and_a_double_one() {
    for apart in [1e-7, 1e-6, 1e-3] {
        let found = roots(&with_roots(1.0, &[0.3, 0.3 + apart]));
        assert_eq!(found.len(), 2, "{apart}: {found:?}");
        // Bounded by the errors of the coefficients over the slope.
        assert!((found[0].at - 0.3).abs() < 1e-16 / apart);
        assert!((found[1].at - 0.3 - apart).abs() < 1e-16 / apart);
        assert_eq!((found[0].before, found[1].behind), (1.0, 1.0));
    }
    let found = roots(&with_roots(-2.0, &[0.3, 0.3, 1.5, -0.2]));
    assert_eq!(found.len(), 1);
    assert!((found[0].at - 0.3).abs() < 1e-7);
    assert_eq!((found[0].before, found[0].behind), (1.0, 1.0));
    // Roots that are closer count as one.
    let found = roots(&with_roots(1.0, &[0.3, 0.3 + 1e-8]));
    assert_eq!(found.len(), 1);
    assert_eq!((found[0].before, found[0].behind), (1.0, 1.0));
    // The minimum is close to zero, but above it.
    let mut lifted = with_roots(1.0, &[0.3, 0.3]);
    lifted.coefficients[0] += DoubleDouble::from(1e-14);
    assert_eq!(roots(&lifted), []);
}

#[test]
fn roots_of_random_polynomials_are_found() {
    let state = &mut 7;
    for degree in 1..=16 {
        for _ in 0..60 {
            let mut expected: Vec<f64> = (0..degree).map(|_| 3.0 * random(state) - 1.0).collect();
            expected.sort_by(f64::total_cmp);
            let gap = expected.windows(2).map(|pair| pair[1] - pair[0]);
            let gap = gap.fold(1.0, f64::min);
            let polynomial = with_roots(random(state) - 0.5, &expected);
            // If the roots are too close for the errors of the coefficients, there is no expected result.
            let slopes = expected.iter().map(|root| polynomial.slope(*root).abs());
            let slope = slopes.fold(f64::INFINITY, f64::min);
            let error = polynomial.uncertainty(2.0) / slope;
            if error > 0.1 * gap {
                continue;
            }
            let far = |root: &f64| *root > error && (root - 1.0).abs() > error;
            if !expected.iter().all(|root| far(&root.abs())) {
                continue;
            }
            let inside = expected.iter().filter(|root| (0.0..=1.0).contains(*root));
            let found = roots(&polynomial);
            let inside: Vec<&f64> = inside.collect();
            assert_eq!(found.len(), inside.len(), "{expected:?} {found:?}");
            for (found, expected) in found.iter().zip(inside) {
                assert!((found.at - expected).abs() <= error);
                assert!(found.before * found.behind < 0.0);
            }
        }
    }
}

/// A multiple root is one crossing or one touch; a polynomial that is zero everywhere has no roots.
#[test]
fn clusters_are_one_root() {
    for (multiplicity, crosses) in [(2, false), (3, true), (4, false), (5, true), (7, true)] {
        let found = roots(&with_roots(1.0, &vec![0.4; multiplicity]));
        let crossings = found.iter().filter(|root| root.before * root.behind < 0.0);
        assert_eq!(
            crossings.count() % 2 == 1,
            crosses,
            "{multiplicity}: {found:?}"
        );
        assert!(found.len() <= 2, "{multiplicity}: {found:?}");
        for root in found {
            assert!((root.at - 0.4).abs() < 0.02, "{multiplicity}: {root:?}");
        }
    }
    assert_eq!(roots(&with_roots(0.0, &[0.4])), []);
    assert!(with_roots(1.0, &[3.0]).has_one_sign());
    assert!(!with_roots(1.0, &[0.999]).has_one_sign());
}

#[test]
fn a_root_at_the_ends_is_one_behind_the_first_and_not_behind_the_last() {
    assert_eq!(roots(&with_roots(1.0, &[0.0, 0.5])).len(), 1);
    assert_eq!(roots(&with_roots(1.0, &[0.5, 1.0 + 1e-9])).len(), 1);
    assert_eq!(roots(&with_roots(1.0, &[0.5, 1.0 - 1e-9])).len(), 2);
    let over = with_roots(1.0, &[0.0, 0.25]).over_argument();
    assert!((roots(&over)[0].at - 0.25).abs() < 1e-15);
}
