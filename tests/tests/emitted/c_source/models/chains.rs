//! Chains of joints.

use lagrangian::prelude::*;

use crate::c_source::agreement::Agreement;
use crate::c_source::checks::{free, input_matrix, state_matrix};
use crate::c_source::program::Case;

/// How nearly derivatives column by column agree.
const UNITS: f64 = 64.0;

/// A chain of joints in a plane, whose accelerations are found along the links.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(q[5]),
    define(
        angle[0] = q[0],
        angle[i] = angle[i - 1] + q[i] for i in 1..5,
        p[0] = l[0] * [sin(angle[0]), -cos(angle[0])],
        p[i] = p[i - 1] + l[i] * [sin(angle[i]), -cos(angle[i])] for i in 1..5,
    ),
    kinetic = (0..5).map(|i| 0.5 * m[i] * dot(p[i]).norm_squared()).sum(),
    potential = (0..5).map(|i| m[i] * g * p[i].y).sum(),
    force(q[i] = push[i] - 0.1 * dot(q[i]) for i in 0..5),
    c,
)]
pub(in super::super) struct Chain {
    m: [f64; 5],
    l: [f64; 5],
    g: f64,
    #[lagrangian(input)]
    push: [f64; 5],
}

/// With this mass of the fourth link. If it is negative enough, accelerations are solved for numerically.
pub(in super::super) fn chain(mass: f64) -> Case {
    let (m, l) = ([1.0, 0.5, 0.75, mass, 0.25], [0.5, 0.4, 0.3, 0.6, 0.2]);
    let model = move |u: &[f64]| Chain {
        m,
        l,
        g: 9.81,
        push: std::array::from_fn(|i| u[i]),
    };
    let mut checks = free!(5, model);
    checks.push(state_matrix!(5, model, "b, "));
    let call = "double a2[100]; $_linearize(POINT, a2, y, NULL);";
    checks.push(input_matrix!(5, 5, model, call));
    Case {
        prefix: "chain",
        source: Chain::C_SOURCE,
        header: Chain::C_HEADER,
        casadi: Chain::C_CASADI,
        parameters: [&m[..], &l, &[9.81]].concat(),
        coordinates: 5,
        inputs: 5,
        checks,
        agreement: Agreement::Bits,
    }
}

/// A chain of so many links that the derivatives of its accelerations are computed column by column.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(theta[60]),
    define(
        p[0] = l[0] * [sin(theta[0]), -cos(theta[0])],
        p[i] = p[i - 1] + l[i] * [sin(theta[i]), -cos(theta[i])] for i in 1..60,
    ),
    kinetic = (0..60).map(|i| 0.5 * m[i] * dot(p[i]).norm_squared()).sum(),
    potential = (0..60).map(|i| m[i] * g * p[i].y).sum(),
    force(theta[i] = -0.1 * dot(theta[i]) for i in 0..60),
    force(theta[0] = push[0] * sin(t), theta[30] = push[1] * cos(theta[30]) * push[2]),
    c,
)]
pub(in super::super) struct LongChain {
    m: [f64; 60],
    l: [f64; 60],
    g: f64,
    #[lagrangian(input)]
    push: [f64; 3],
}

pub(in super::super) fn long_chain() -> Case {
    let model = move |u: &[f64]| LongChain {
        m: [0.1; 60],
        l: [0.05; 60],
        g: 9.81,
        push: std::array::from_fn(|i| u[i]),
    };
    let mut checks = free!(60, model);
    checks.push(state_matrix!(60, model, "b, ").within(UNITS));
    let call = "static double a2[14400]; $_linearize(POINT, a2, y, NULL);";
    checks.push(input_matrix!(60, 3, model, call).within(UNITS));
    Case {
        prefix: "long_chain",
        source: LongChain::C_SOURCE,
        header: LongChain::C_HEADER,
        casadi: LongChain::C_CASADI,
        parameters: [&[0.1; 60][..], &[0.05; 60], &[9.81]].concat(),
        coordinates: 60,
        inputs: 3,
        checks,
        agreement: Agreement::Bits,
    }
}
