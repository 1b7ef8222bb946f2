//! An arm of bodies in space.

use lagrangian::prelude::*;
use lagrangian::rigid_body::Solid;

use crate::c_source::agreement::Agreement;
use crate::c_source::checks::{body, check, free, input_matrix, state_matrix};
use crate::c_source::program::Case;

/// An arm of bodies, a family of coordinates and of parameters, a vector and a matrix.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(q[3]),
    define(
        turned = rotation_z(q[0]),
        raised = turned * rotation_y(q[1]),
        bent = raised * rotation_y(q[2]),
        elbow = shoulder + raised * [length, 0.0, 0.0],
    ),
    body(column = (turned, [0.0, 0.0, 0.0]), upper = (raised, shoulder), lower = (bent, elbow)),
    gravity = [0.0, 0.0, -g],
    force(q[i] = -stiffness[i] * q[i] for i in 0..3),
    force(q[i] = torque[i] for i in 0..3),
    output(hand = elbow + bent * (mount * lower.center)),
    c,
)]
pub(in super::super) struct Arm3R {
    column: SymmetricBody,
    upper: RigidBody,
    lower: RigidBody,
    shoulder: Vector3<f64>,
    mount: Matrix3<f64>,
    stiffness: [f64; 3],
    length: f64,
    g: f64,
    #[lagrangian(input)]
    torque: [f64; 3],
}

pub(in super::super) fn arm() -> Case {
    let solid = |size: f64, mass: f64| {
        let solid = Solid::cylinder(size, 2.0 * size).expect("a cylinder");
        solid.with_mass(mass).expect("a body")
    };
    let column = SymmetricBody::of(&solid(0.3, 20.0)).expect("a symmetric body");
    let turned = nalgebra::Rotation3::from_euler_angles(0.3, -0.5, 1.1);
    let [upper, lower] = [(0.2, 3.0), (0.1, 2.0)].map(|(size, mass)| {
        solid(size, mass)
            .turned(&turned)
            .moved(Vector3::new(0.3, 0.02, -0.01))
    });
    let shoulder = Vector3::new(0.1, 0.05, 0.5);
    let mount = Matrix3::new(1.0, 0.1, 0.0, -0.2, 0.9, 0.3, 0.0, 0.25, 1.1);
    let model = move |u: &[f64]| Arm3R {
        column,
        upper,
        lower,
        shoulder,
        mount,
        stiffness: [0.5, 0.25, 0.125],
        length: 0.6,
        g: 9.81,
        torque: [u[0], u[1], u[2]],
    };
    let parameters = [
        body!(column),
        body!(upper),
        body!(lower),
        shoulder.as_slice().to_vec(),
        mount.transpose().as_slice().to_vec(),
        vec![0.5, 0.25, 0.125, 0.6, 9.81],
    ];
    let mut checks = free!(3, model);
    checks.push(state_matrix!(3, model, "b, "));
    let call = "double a2[36]; $_linearize(POINT, a2, y, NULL);";
    checks.push(input_matrix!(3, 3, model, call));
    let call = "$_outputs o; $_compute_outputs(POINT, &o); memcpy(y, &o, sizeof o);";
    checks.push(check("outputs", 3, call, move |point| {
        Some(
            model(&point.u)
                .outputs(&point.state::<3>())
                .hand
                .as_slice()
                .to_vec(),
        )
    }));
    Case {
        prefix: "arm3_r",
        source: Arm3R::C_SOURCE,
        header: Arm3R::C_HEADER,
        casadi: Arm3R::C_CASADI,
        parameters: parameters.concat(),
        coordinates: 3,
        inputs: 3,
        checks,
        agreement: Agreement::Bits,
    }
}
