//! A mass matrix that is not positive definite.

use lagrangian::prelude::*;

use crate::c_source::agreement::Agreement;
use crate::c_source::checks::{free, state_matrix};
use crate::c_source::program::Case;

/// A mass matrix that is not positive definite, with rows of different sizes.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(a, b, c, d, e),
    lagrangian = dot(a) * dot(b) + 0.5 * dot(a).powi(2) * cos(b + c) + dot(b) * dot(c) * sin(a + d)
        + 0.5 * dot(c).powi(2) * (2.0 + cos(d + e)) + 250.0 * dot(c) * dot(e) * sin(b)
        + dot(d) * dot(e) * (3.0 + sin(a)) + 0.5 * dot(d).powi(2) * cos(c) + 0.3 * dot(a) * dot(e) * cos(d)
        + 0.2 * dot(b) * dot(d) * sin(c + e) + dot(a) * b - k * (a.powi(2) + b * c + sin(d) * e),
    force(d = -dot(d), e = t * dot(a)),
    c,
)]
pub(in super::super) struct Indefinite {
    k: f64,
}

pub(in super::super) fn indefinite() -> Case {
    let model = |_: &[f64]| Indefinite { k: 0.7 };
    let mut checks = free!(5, model);
    checks.push(state_matrix!(5, model, ""));
    Case {
        prefix: "indefinite",
        source: Indefinite::C_SOURCE,
        header: Indefinite::C_HEADER,
        casadi: Indefinite::C_CASADI,
        parameters: vec![0.7],
        coordinates: 5,
        inputs: 0,
        checks,
        agreement: Agreement::Bits,
    }
}
