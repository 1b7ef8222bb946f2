//! A linkage and a rolling disc, with the derivatives of their motions by the state and by parameters.

use lagrangian::prelude::*;
use lagrangian_tests::Random;

use crate::c_source::agreement::Agreement;
use crate::c_source::checks::{
    check, constrained, constrained_state_matrix, input_matrix, sensitivities,
};
use crate::c_source::point::Point;
use crate::c_source::program::Case;

/// How nearly derivatives under constraints agree.
const UNITS: f64 = 64.0;

/// A four-bar linkage with a drive at the crank and a support that shakes.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(crank, coupler, rocker),
    define(
        pin = [a * cos(crank), a * sin(crank)],
        arm = [b * cos(coupler), b * sin(coupler)],
        end = [d + 0.01 * sin(5.0 * t) + c * cos(rocker), c * sin(rocker)],
        middle = pin + 0.5 * arm,
    ),
    kinetic = m * (a.powi(2) * dot(crank).powi(2) + c.powi(2) * dot(rocker).powi(2)) / 6.0,
    kinetic = 0.5 * m * (dot(middle).norm_squared() + b.powi(2) / 12.0 * dot(coupler).powi(2)),
    potential = 0.5 * k * crank.powi(2) + m * g * middle.y,
    dissipation = 0.05 * dot(rocker).powi(2),
    force(crank = drive * cos(crank - rocker)),
    constraint(joint = pin + arm - end),
    sensitivities(k, m),
    c,
)]
pub(in super::super) struct FourBar {
    m: f64,
    a: f64,
    b: f64,
    c: f64,
    d: f64,
    g: f64,
    k: f64,
    #[lagrangian(input)]
    drive: f64,
}

pub(in super::super) fn four_bar() -> Case {
    let model = |u: &[f64]| FourBar {
        m: 0.7,
        a: 0.4,
        b: 1.1,
        c: 0.9,
        d: 1.0,
        g: 9.81,
        k: 20.0,
        drive: u[0],
    };
    let mut checks = constrained!(3, 2, model);
    checks.push(constrained_state_matrix!(3, 2, model, "b, ").within(UNITS));
    checks.push(input_matrix!(
        3,
        1,
        model,
        "$_linearize(POINT, NULL, y, NULL);"
    ));
    checks.push(sensitivities!(3, 2, model));
    Case {
        prefix: "four_bar",
        source: FourBar::C_SOURCE,
        header: FourBar::C_HEADER,
        casadi: FourBar::C_CASADI,
        parameters: vec![0.7, 0.4, 1.1, 0.9, 1.0, 9.81, 20.0],
        coordinates: 3,
        inputs: 1,
        checks,
        agreement: Agreement::Bits,
    }
}

/// Points near assembled positions.
pub(in super::super) fn points_of_four_bar(count: usize) -> Vec<Point> {
    let mut random = Random::default();
    let mut points = Vec::with_capacity(count);
    for _ in 0..count {
        let mut point = Point::random(&mut random, 3, 1);
        // The coupler and the rocker close a triangle over the crank.
        let crank = point.q[0];
        let (x, y) = (1.0 - 0.4 * crank.cos(), -0.4 * crank.sin());
        let (side, angle) = (x.hypot(y), y.atan2(x));
        let at_pin = ((1.1_f64.powi(2) + side * side - 0.81) / (2.2 * side)).acos();
        let (x, y) = (
            0.4 * crank.cos() + 1.1 * (angle + at_pin).cos() - 1.0,
            0.4 * crank.sin() + 1.1 * (angle + at_pin).sin(),
        );
        point.q[1] = angle + at_pin + point.q[1] / 100.0;
        point.q[2] = y.atan2(x) + point.q[2] / 100.0;
        point.h = 1.0 / 1024.0;
        points.push(point);
    }
    points
}

/// Points where the disc is less than a radian from upright: as it lies flat, its coordinates are singular.
pub(in super::super) fn points_of_disc(count: usize) -> Vec<Point> {
    let mut random = Random::default();
    let mut point = || {
        let mut point = Point::random(&mut random, 5, 2);
        point.q[3] = (3.0 * core::f64::consts::FRAC_PI_2 + point.q[3]) / 3.0;
        point
    };
    (0..count).map(|_| point()).collect()
}

/// A disc that rolls on a plane, driven at its axle, with the point of contact as coordinates.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(x, y, yaw, lean, spin),
    define(center = [x - r * cos(lean) * sin(yaw), y + r * cos(lean) * cos(yaw), r * sin(lean)]),
    kinetic = 0.5 * m * dot(center).norm_squared(),
    kinetic = 0.5 * across * (dot(lean).powi(2) + (dot(yaw) * sin(lean)).powi(2)),
    kinetic = 0.5 * axial * (dot(spin) + dot(yaw) * cos(lean)).powi(2),
    potential = m * g * center.z,
    force(spin = torque, lean = tilt * sin(t)),
    nonholonomic(
        along = dot(x) + r * dot(spin) * cos(yaw),
        aside = dot(y) + r * dot(spin) * sin(yaw),
    ),
    sensitivities,
    c,
)]
pub(in super::super) struct RollingDisc {
    m: f64,
    r: f64,
    across: f64,
    axial: f64,
    g: f64,
    #[lagrangian(input)]
    torque: f64,
    #[lagrangian(input)]
    tilt: f64,
}

pub(in super::super) fn rolling_disc() -> Case {
    let model = |u: &[f64]| RollingDisc {
        m: 1.5,
        r: 0.3,
        across: 0.04,
        axial: 0.07,
        g: 9.81,
        torque: u[0],
        tilt: u[1],
    };
    let mut checks = constrained!(5, 2, model);
    checks.push(constrained_state_matrix!(5, 2, model, "b, ").within(UNITS));
    checks.push(input_matrix!(
        5,
        2,
        model,
        "$_linearize(POINT, NULL, y, NULL);"
    ));
    checks.push(sensitivities!(5, 5, model));
    // What CasADi gets has these derivatives by the parameters, column by column.
    let call = "extern int jac_$_dynamics(const double **, double **, long long int *, double *, int); double x[10]; \
                memcpy(x, q, sizeof q); memcpy(x + 5, v, sizeof v); \
                const double *arg[5] = {&t, x, u, (const double *)&p, NULL}; double *res[4] = {NULL, NULL, NULL, y}; \
                jac_$_dynamics(arg, res, NULL, NULL, 0);";
    checks.push(check("Jacobian by parameters", 50, call, move |point| {
        let found = model(&point.u).sensitivities::<5>(&point.state::<5>());
        let columns = found.column_iter();
        Some(
            columns
                .flat_map(|column| [&[0.0; 5][..], column.as_slice()].concat())
                .collect(),
        )
    }));
    Case {
        prefix: "rolling_disc",
        source: RollingDisc::C_SOURCE,
        header: RollingDisc::C_HEADER,
        casadi: RollingDisc::C_CASADI,
        parameters: vec![1.5, 0.3, 0.04, 0.07, 9.81],
        coordinates: 5,
        inputs: 2,
        checks,
        agreement: Agreement::Bits,
    }
}
