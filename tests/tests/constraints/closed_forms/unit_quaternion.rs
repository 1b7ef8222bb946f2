//! A free body whose orientation is a unit quaternion, so that its mass matrix is singular: against the motion in Jacobi's functions.

use lagrangian::prelude::*;
use lagrangian::rigid_body::{FreeRotation, InertiaTensor, RotationState};
use lagrangian_tests::Figures;
use nalgebra::{Quaternion, UnitQuaternion, Vector3};

use super::{by_both_methods, compare};

/// A body about its centre of gravity, with ω along the axes of the body.
#[derive(Clone, Lagrangian)]
#[lagrangian(
    taylor,
    coordinates(e: Vector4),
    define(
        axis = e.rows(1, 3),
        w = 2.0 * (e[0] * dot(axis) - dot(e[0]) * axis - axis.cross(dot(axis))),
    ),
    kinetic = 0.5 * w.dot(moments.component_mul(w)),
    constraint(unit = e.norm_squared() - 1.0),
    output(w = w),
)]
struct FreeBody {
    moments: nalgebra::Vector3<f64>,
}

#[test]
fn a_turned_body_turns_as_jacobi_says() {
    follow(&UnitQuaternion::from_euler_angles(0.4, -0.7, 1.1));
}

#[test]
fn a_body_turns_as_jacobi_says() {
    follow(&UnitQuaternion::identity());
}

fn follow(orientation: &UnitQuaternion<f64>) {
    let body = FreeBody {
        moments: Vector3::new(1.0, 2.0, 2.5),
    };
    let w = Vector3::new(0.3, -0.4, 2.0);
    let rate = orientation.into_inner() * Quaternion::from_imag(0.5 * w);
    let of = |e: &Quaternion<f64>| [e.w, e.i, e.j, e.k];
    let start = State::new(0.0, of(orientation), of(&rate));
    let tensor = InertiaTensor::principal(body.moments.into());
    let solution = FreeRotation::new(&tensor, &RotationState::new(orientation, w));
    let solution = solution.expect("a motion");
    let mut figures = Figures::new();
    for (tolerance, states) in by_both_methods(&body, start, (20.0, 100)) {
        for state in &states {
            let at = (state.t, tolerance);
            let expected = solution.at(state.t);
            let found = body.outputs(state).w;
            let w = expected.angular_velocity;
            compare(
                &mut figures,
                "angular velocity",
                at,
                found.as_slice(),
                w.as_slice(),
            );
            // Both signs are the same orientation.
            let e = expected.quaternion;
            let found = state.q * state.q.dot(&e).signum();
            compare(
                &mut figures,
                "orientation",
                at,
                found.as_slice(),
                e.as_slice(),
            );
        }
    }
    figures.finish();
}
