//! Names that are written otherwise in C, and a model without parameters.

use lagrangian::prelude::*;

use crate::c_source::agreement::Agreement;
use crate::c_source::checks::{check, free, state_matrix};
use crate::c_source::program::Case;

/// Names that C has for itself, or not at all.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(int, θ),
    kinetic = 0.5 * double * dot(int).powi(2) + 0.5 * λ * dot(θ).powi(2),
    potential = register * cos(int - θ),
    output(double_ = int + double, void = θ),
    c,
)]
#[allow(non_snake_case)]
pub(in super::super) struct Signed {
    double: f64,
    λ: f64,
    register: f64,
}

pub(in super::super) fn names() -> Case {
    let model = |_: &[f64]| Signed {
        double: 1.5,
        λ: 0.75,
        register: 2.25,
    };
    let call = "$_outputs o; $_compute_outputs(POINT, &o); memcpy(y, &o, sizeof o);";
    let mut checks = free!(2, model);
    checks.push(check("outputs", 2, call, move |point| {
        let found = model(&[]).outputs(&point.state::<2>());
        Some(vec![found.double_, found.void])
    }));
    Case {
        prefix: "signed_",
        source: Signed::C_SOURCE,
        header: Signed::C_HEADER,
        casadi: Signed::C_CASADI,
        parameters: vec![1.5, 0.75, 2.25],
        coordinates: 2,
        inputs: 0,
        checks,
        agreement: Agreement::Bits,
    }
}

/// A model without parameters.
#[derive(Lagrangian)]
#[lagrangian(coordinates(x), kinetic = 0.5 * dot(x).powi(2), potential = 0.5 * x.powi(2), c)]
pub(in super::super) struct Oscillator {}

pub(in super::super) fn oscillator() -> Case {
    let model = |_: &[f64]| Oscillator {};
    let mut checks = free!(1, model);
    checks.push(state_matrix!(1, model, ""));
    Case {
        prefix: "oscillator",
        source: Oscillator::C_SOURCE,
        header: Oscillator::C_HEADER,
        casadi: Oscillator::C_CASADI,
        parameters: Vec::new(),
        coordinates: 1,
        inputs: 0,
        checks,
        agreement: Agreement::Bits,
    }
}
