//! Ready models in C.

use lagrangian::prelude::*;
use lagrangian_models::{Bicycle, FurutaPendulum, GeneralTop, StewartPlatform};
use lagrangian_tests::Random;

use super::agreement::Agreement;
use super::checks::{
    PROJECTIONS, body, check, constrained, constrained_state_matrix, free, input_matrix,
    on_constraints, state_matrix,
};
use super::point::Point;
use super::program::Case;

/// How nearly derivatives under constraints agree.
const UNITS: f64 = 64.0;

/// A body without symmetry.
fn rigid_body() -> RigidBody {
    let inertia = Matrix3::new(0.5, 0.02, -0.03, 0.02, 0.6, 0.05, -0.03, 0.05, 0.4);
    let inertia = lagrangian::rigid_body::InertiaTensor::from_matrix(&inertia).expect("symmetric");
    RigidBody::new(1.5, Vector3::new(0.1, -0.05, 0.4), inertia).expect("a body")
}

pub(super) fn general_top() -> Case {
    let body = rigid_body();
    let model = move |_: &[f64]| GeneralTop { body, g: 9.81 };
    let mut checks = free!(3, model);
    checks.push(state_matrix!(3, model, ""));
    Case {
        prefix: "general_top",
        source: GeneralTop::C_SOURCE,
        header: GeneralTop::C_HEADER,
        casadi: GeneralTop::C_CASADI,
        parameters: [body!(body), vec![9.81]].concat(),
        coordinates: 3,
        inputs: 0,
        checks,
        agreement: Agreement::Bits,
    }
}

pub(super) fn furuta_pendulum() -> Case {
    let arm = PrincipalBody::new(0.3, [0.01, 0.02, 0.025]).expect("a body");
    let rod = rigid_body();
    let model = move |u: &[f64]| FurutaPendulum {
        arm,
        rod,
        length: 0.4,
        g: 9.81,
        torque: u[0],
    };
    let mut checks = free!(2, model);
    checks.push(state_matrix!(2, model, "b, "));
    let call = "double a2[16]; $_linearize(POINT, a2, y, NULL);";
    checks.push(input_matrix!(2, 1, model, call));
    Case {
        prefix: "furuta_pendulum",
        source: FurutaPendulum::C_SOURCE,
        header: FurutaPendulum::C_HEADER,
        casadi: FurutaPendulum::C_CASADI,
        parameters: [body!(arm), body!(rod), vec![0.4, 9.81]].concat(),
        coordinates: 2,
        inputs: 1,
        checks,
        agreement: Agreement::Bits,
    }
}

pub(super) fn bicycle() -> Case {
    let own: &'static Bicycle = Box::leak(Box::new(Bicycle::benchmark().expect("bodies")));
    let model = move |u: &[f64]| Bicycle {
        lean_torque: u[0],
        steer_torque: u[1],
        drive: u[2],
        ..own.clone()
    };
    let mut checks = constrained!(8, 5, model);
    checks.push(constrained_state_matrix!(8, 5, model, "b, ").within(UNITS));
    checks.push(input_matrix!(
        8,
        3,
        model,
        "$_linearize(POINT, NULL, y, NULL);"
    ));
    let parameters = [
        body!(own.rear_frame),
        body!(own.front_frame),
        vec![
            own.rear_mass,
            own.rear_radius,
            own.rear_axial,
            own.rear_across,
            own.front_mass,
            own.front_radius,
            own.front_axial,
            own.front_across,
            own.wheelbase,
            own.trail,
            own.tilt,
            own.g,
        ],
    ];
    Case {
        prefix: "bicycle",
        source: Bicycle::C_SOURCE,
        header: Bicycle::C_HEADER,
        casadi: Bicycle::C_CASADI,
        parameters: parameters.concat(),
        coordinates: 8,
        inputs: 3,
        checks,
        agreement: Agreement::Bits,
    }
}

/// Points near motions along a straight line.
pub(super) fn points_of_bicycle(count: usize) -> Vec<Point> {
    let own = Bicycle::benchmark().expect("bodies");
    near(count, 3, |_, random| own.straight(random.between(1.0, 8.0)))
}

fn stewart() -> StewartPlatform {
    let symmetric = |mass, height, across, axial| {
        SymmetricBody::new(mass, height, across, axial).expect("a body")
    };
    StewartPlatform {
        platform: symmetric(40.0, 0.05, 2.0, 4.0),
        cylinder: [symmetric(3.0, 0.3, 0.35, 0.01); 6],
        rod: [symmetric(1.5, -0.3, 0.18, 0.002); 6],
        base: StewartPlatform::hexagon(1.0, 0.2),
        top: StewartPlatform::hexagon(0.6, 0.85),
        height: 1.0,
        radius: 0.1,
        omega: 2.0,
        g: 9.81,
    }
}

pub(super) fn stewart_platform() -> Case {
    let own: &'static StewartPlatform = Box::leak(Box::new(stewart()));
    let model = move |_: &[f64]| own.clone();
    let mut checks = constrained!(24, 24, model);
    checks.push(constrained_state_matrix!(24, 24, model, "").within(UNITS));
    let call = format!(
        "{PROJECTIONS} $_outputs o; {} memcpy(y, &o, sizeof o);",
        "$_compute_outputs(MOVED, &o);"
    );
    checks.push(check("outputs", 9, &call, move |point| {
        let model = model(&[]);
        let on = on_constraints!(model, point, 24);
        let found = model.outputs(&on);
        Some([found.carried.as_slice(), found.force.as_slice()].concat())
    }));
    let bodies = [own.platform]
        .into_iter()
        .chain(own.cylinder)
        .chain(own.rod);
    let points = own.base.iter().chain(&own.top);
    let mut parameters: Vec<f64> = bodies.flat_map(|body| body!(body)).collect();
    parameters.extend(points.flat_map(|point| point.iter().copied()));
    parameters.extend([own.height, own.radius, own.omega, own.g]);
    Case {
        prefix: "stewart_platform",
        source: StewartPlatform::C_SOURCE,
        header: StewartPlatform::C_HEADER,
        casadi: StewartPlatform::C_CASADI,
        parameters,
        coordinates: 24,
        inputs: 0,
        checks,
        agreement: Agreement::Bits,
    }
}

/// Points near the way of the platform.
pub(super) fn points_of_platform(count: usize) -> Vec<Point> {
    let own = stewart();
    near(count, 0, |t, _| own.guess(t))
}

/// Random points near some states.
fn near<const N: usize>(
    count: usize,
    inputs: usize,
    state: impl Fn(f64, &mut Random) -> State<f64, N>,
) -> Vec<Point> {
    let mut random = Random::default();
    let mut points = Vec::with_capacity(count);
    for _ in 0..count {
        let mut point = Point::random(&mut random, N, inputs);
        let state = state(point.t, &mut random);
        for i in 0..N {
            point.q[i] = state.q[i] + point.q[i] / 100.0;
            point.v[i] = state.v[i] + point.v[i] / 100.0;
        }
        point.h = 1.0 / 1024.0;
        points.push(point);
    }
    points
}
