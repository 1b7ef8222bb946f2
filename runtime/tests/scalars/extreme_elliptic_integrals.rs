//! Elliptic integrals of arguments from 1e-300 to 1e300, against values that mpmath computed with 330 digits
//! (`tests/data/extreme_elliptic_integrals.py`), and closed forms.

use crate::common::assert_close;
use lagrangian::DoubleDouble;
use lagrangian::elliptic::{Modulus, carlson_rc, carlson_rf, carlson_rj};
use lagrangian::prelude::*;

type D = DoubleDouble;

fn d(value: f64) -> D {
    D::from_f64(value)
}

const DATA: &str = include_str!("../../../tests/data/extreme_elliptic_integrals.txt");

/// The rows of numbers behind a name.
fn rows<const N: usize>(name: &'static str) -> impl Iterator<Item = [f64; N]> {
    let rows = DATA.lines().filter_map(move |line| line.strip_prefix(name));
    rows.map(|row| {
        let numbers = row.split_whitespace().map(|word| word.parse().unwrap());
        numbers.collect::<Vec<f64>>().try_into().unwrap()
    })
}

#[test]
fn all_rows_are_read() {
    assert_eq!(rows::<7>("carlson ").count(), 18);
    assert_eq!(rows::<6>("third ").count(), 14);
    assert_eq!(DATA.lines().count(), 32);
}

/// Arguments from 1e-300 to 1e300, and 0: x, y, z, p, with `R_F`(x, y, z), `R_C`(x, p) and `R_J`(x, y, z, p).
#[test]
fn integrals_of_carlson_of_extreme_arguments() {
    for [x, y, z, p, first, elementary, third] in rows("carlson ") {
        for [x, y, z] in [[x, y, z], [z, x, y], [y, z, x]] {
            assert_close(carlson_rf(x, y, z) / first, 1.0, 4e-15);
            assert_close(carlson_rj(x, y, z, p) / third, 1.0, 4e-15);
        }
        if elementary.is_normal() {
            assert_close(carlson_rc(x, p) / elementary, 1.0, 4e-15);
        }
    }
}

/// `R_J`(0, y, y, p) = 3π/(2 (y √p + p √y)), and `R_J`(y, y, y, p) in arcs.
#[test]
fn the_third_integral_in_closed_form() {
    for exponent in (-300_i32..=300).step_by(20) {
        for other in (-280..=280).step_by(35) {
            let (y, p) = (
                libm::exp10(f64::from(exponent)),
                libm::exp10(f64::from(other)),
            );
            let root = p.sqrt() * y.sqrt();
            let expected = 1.5 * std::f64::consts::PI / root / (y.sqrt() + p.sqrt());
            if expected.is_normal() {
                assert_close(carlson_rj(0.0, y, y, p) / expected, 1.0, 1e-14);
                assert_close(carlson_rj(y, y, 0.0, p) / expected, 1.0, 1e-14);
            }
            let expected = 3.0 / (y - p) * (carlson_rc(y, p) - 1.0 / y.sqrt());
            if expected.is_normal() && (exponent - other).abs() > 2 {
                assert_close(carlson_rj(y, y, y, p) / expected, 1.0, 1e-14);
            }
        }
    }
    for e in [20, 40, 60, 80, 100, 120, 160, 200] {
        let y = libm::exp10(f64::from(-e));
        let expected = d(1.5) * D::pi() / (d(y) + d(y).sqrt());
        let error = carlson_rj(d(0.0), d(y), d(y), d(1.0)) / expected - d(1.0);
        assert!(error.to_f64().abs() < 1e-28, "{e}: {error:?}");
    }
    for e in [5_i16, 10, 20, 30, 36] {
        let y = libm::exp10f(f32::from(-e));
        let expected = 1.5 * std::f32::consts::PI / (y + y.sqrt());
        assert!(
            (carlson_rj(0.0_f32, y, y, 1.0) / expected - 1.0).abs() < 4e-6,
            "{e}"
        );
    }
}

#[test]
fn integrals_that_diverge_are_infinite() {
    let [x, zero] = [2.0_f64, 0.0];
    for found in [
        carlson_rf(zero, zero, x),
        carlson_rf(zero, zero, zero),
        carlson_rc(x, zero),
        carlson_rj(zero, x, zero, x),
        carlson_rj(x, x, x, zero),
    ] {
        assert!(found > 1e300 && found.is_infinite(), "{found}");
    }
    for found in [
        carlson_rf(-x, x, x),
        carlson_rc(-x, x),
        carlson_rj(x, -x, x, x),
    ] {
        assert!(found.is_nan(), "{found}");
    }
}

/// n, m, sin φ and cos φ, with Π(n|m) and Π(n; φ|m): of both signs of n the terms of the defining sum would cancel.
#[test]
fn integrals_of_the_third_kind_of_large_characteristics() {
    for [n, m, sine, cosine, complete, incomplete] in rows("third ") {
        let modulus = Modulus::new(m, 1.0 - m);
        assert_close(modulus.complete_third(n) / complete, 1.0, 4e-15);
        assert_close(modulus.third(n, sine, cosine) / incomplete, 1.0, 8e-15);
    }
}
