//! Constraints that depend on each other.

use lagrangian::prelude::*;

use crate::c_source::agreement::Agreement;
use crate::c_source::checks::{
    PROJECTIONS, check, constrained, constrained_state_matrix, input_matrix, on_constraints,
};
use crate::c_source::program::Case;

/// How nearly derivatives under constraints agree.
const UNITS: f64 = 64.0;

/// Constraints that depend on each other where they hold, with compliances, beside one that does not.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(p: Vector3, w, s, r),
    kinetic = 0.5 * m * dot(p).norm_squared() + 0.5 * inertia * dot(w).powi(2) + 0.5 * (dot(s) - 0.2 * dot(r)).powi(2) + 0.25 * dot(r).powi(2),
    potential = m * g * p.y,
    force(p = [push, 0.0, wind], w = -w),
    constraint(rod = 0.5 * (p.norm_squared() - l.powi(2)), wall = p.z, frame = p.z * (1.0 + w.powi(2))),
    nonholonomic(roll = dot(s) - p.y * dot(r)),
    compliance(wall = soft, frame = hard),
    output(tension = l * reaction(rod), carried = [reaction(wall), reaction(frame)], turning = dot(dot(w))),
    c,
)]
pub(in super::super) struct Guided {
    m: f64,
    inertia: f64,
    g: f64,
    l: f64,
    soft: f64,
    hard: f64,
    #[lagrangian(input)]
    push: f64,
    #[lagrangian(input)]
    wind: f64,
}

pub(in super::super) fn guided() -> Case {
    let model = |u: &[f64]| Guided {
        m: 0.8,
        inertia: 0.3,
        g: 9.81,
        l: 2.0,
        soft: 0.5,
        hard: 0.125,
        push: u[0],
        wind: u[1],
    };
    let mut checks = constrained!(6, 4, model);
    checks.push(constrained_state_matrix!(6, 4, model, "b, ").within(UNITS));
    checks.push(input_matrix!(
        6,
        2,
        model,
        "$_linearize(POINT, NULL, y, NULL);"
    ));
    let call = "$_outputs o; $_compute_outputs(POINT, &o); memcpy(y, &o, sizeof o);";
    checks.push(check("outputs", 4, call, move |point| {
        let found = model(&point.u).outputs(&point.state::<6>());
        Some(
            [
                &[found.tension][..],
                found.carried.as_slice(),
                &[found.turning],
            ]
            .concat(),
        )
    }));
    let call = format!("{PROJECTIONS} $_accelerations(MOVED, y, y + 6);");
    checks.push(check(
        "multipliers of least norm",
        10,
        &call,
        move |point| {
            let model = model(&point.u);
            let on = on_constraints!(model, point, 6);
            let (a, lambda) = (model.accelerations(&on), model.multipliers::<4>(&on));
            Some([a.as_slice(), lambda.as_slice()].concat())
        },
    ));
    checks.push(check(
        "residuals",
        8,
        "$_constraint_residuals(POINT, y, y + 4);",
        move |point| {
            let (of_q, of_v) = model(&point.u).constraint_residuals::<4>(&point.state::<6>());
            Some([of_q.as_slice(), of_v.as_slice()].concat())
        },
    ));
    Case {
        prefix: "guided",
        source: Guided::C_SOURCE,
        header: Guided::C_HEADER,
        casadi: Guided::C_CASADI,
        parameters: vec![0.8, 0.3, 9.81, 2.0, 0.5, 0.125],
        coordinates: 6,
        inputs: 2,
        checks,
        agreement: Agreement::Bits,
    }
}
