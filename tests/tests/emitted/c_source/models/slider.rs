//! A reduced model.

use lagrangian::prelude::*;

use crate::c_source::agreement::Agreement;
use crate::c_source::checks::{check, free, state_matrix};
use crate::c_source::program::Case;

/// A mass that slides on a turning rod, whose angle is ignorable, with parameters of any scalar.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(r, phi),
    kinetic = 0.5 * m * (dot(r).powi(2) + (r * dot(phi)).powi(2)) + 0.5 * i * dot(phi).powi(2),
    potential = 0.5 * k * r.powi(2),
    output(rate = dot(phi)),
    routhian(Radial),
    c,
)]
pub(in super::super) struct Slider<T: Scalar> {
    m: T,
    i: T,
    k: T,
}

/// The reduced model.
pub(in super::super) fn radial() -> Case {
    let model = |_: &[f64]| {
        let slider = Slider {
            m: 1.5,
            i: 0.25,
            k: 3.0,
        };
        slider.reduce(&State::new(0.0, [1.0, 0.0], [0.0, 1.5])).0
    };
    let mut checks = free!(1, model);
    checks.push(state_matrix!(1, model, ""));
    let call = "$_outputs o; $_compute_outputs(POINT, &o); y[0] = o.rate;";
    checks.push(check("outputs", 1, call, move |point| {
        Some(vec![model(&[]).outputs(&point.state::<1>()).rate])
    }));
    Case {
        prefix: "radial",
        source: Radial::<f64>::C_SOURCE,
        header: Radial::<f64>::C_HEADER,
        casadi: Radial::<f64>::C_CASADI,
        parameters: vec![1.5, 0.25, 3.0, model(&[]).p_phi],
        coordinates: 1,
        inputs: 0,
        checks,
        agreement: Agreement::Bits,
    }
}
