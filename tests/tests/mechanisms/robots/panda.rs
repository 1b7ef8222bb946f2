//! The Panda of Franka Emika, seven joints, with the inertial parameters that Gaz, Cognetti, Oliva, Robuffo Giordano and De Luca
//! identified (Dynamic identification of the Franka Emika Panda robot with retrieval of feasible parameters using
//! penalty-based optimization, 2019).

use core::f64::consts::FRAC_PI_2;

use lagrangian::prelude::*;
use lagrangian_tests::{Random, relative_error};
use nalgebra::{Matrix3, Rotation3, Vector3};

use super::recursion::{Link, Motion, assert_moves_as};

/// By the modified parameters of Denavit and Hartenberg (Craig, Introduction to Robotics, 2005): the twist comes before the
/// joint.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(q[7]),
    define(
        r[0] = rotation_z(q[0]),
        r[i] = r[i - 1] * rotation_x(twist[i]) * rotation_z(q[i]) for i in 1..7,
        p[0] = place[0],
        p[i] = p[i - 1] + r[i - 1] * place[i] for i in 1..7,
        c[i] = p[i] + r[i] * center[i] for i in 0..7,
        w[i] = angular_velocity(r[i]) for i in 0..7,
    ),
    kinetic = (0..7).map(|i| {
        0.5 * m[i] * dot(c[i]).norm_squared() + 0.5 * w[i].dot(inertia[i] * w[i])
    }).sum(),
    potential = (0..7).map(|i| m[i] * g * c[i].z).sum(),
)]
struct Panda {
    twist: [f64; 7],
    place: [Vector3<f64>; 7],
    m: [f64; 7],
    center: [Vector3<f64>; 7],
    inertia: [Matrix3<f64>; 7],
    g: f64,
}

fn panda() -> Panda {
    let tensor =
        |[xx, xy, xz, yy, yz, zz]: [f64; 6]| Matrix3::new(xx, xy, xz, xy, yy, yz, xz, yz, zz);
    let right = FRAC_PI_2;
    Panda {
        twist: [0.0, -right, right, right, -right, right, right],
        place: [
            [0.0, 0.0, 0.333],
            [0.0, 0.0, 0.0],
            [0.0, -0.316, 0.0],
            [0.0825, 0.0, 0.0],
            [-0.0825, 0.384, 0.0],
            [0.0, 0.0, 0.0],
            [0.088, 0.0, 0.0],
        ]
        .map(Vector3::from),
        m: [
            4.970_684, 0.646_926, 3.228_604, 3.587_895, 1.225_946, 1.666_555, 0.735_522,
        ],
        center: [
            [3.875e-3, 2.081e-3, -0.1750],
            [-3.141e-3, -2.872e-2, 3.495e-3],
            [2.7518e-2, 3.9252e-2, -6.6502e-2],
            [-5.317e-2, 1.044_19e-1, 2.7454e-2],
            [-1.1953e-2, 4.1065e-2, -3.8437e-2],
            [6.0149e-2, -1.4117e-2, -1.0517e-2],
            [1.0517e-2, -4.252e-3, 6.1597e-2],
        ]
        .map(Vector3::from),
        inertia: [
            [
                7.0337e-1, -1.3900e-4, 6.7720e-3, 7.0661e-1, 1.9169e-2, 9.1170e-3,
            ],
            [
                7.9620e-3, -3.9250e-3, 1.0254e-2, 2.8110e-2, 7.0400e-4, 2.5995e-2,
            ],
            [
                3.7242e-2, -4.7610e-3, -1.1396e-2, 3.6155e-2, -1.2805e-2, 1.0830e-2,
            ],
            [
                2.5853e-2, 7.7960e-3, -1.3320e-3, 1.9552e-2, 8.6410e-3, 2.8323e-2,
            ],
            [
                3.5549e-2, -2.1170e-3, -4.0370e-3, 2.9474e-2, 2.2900e-4, 8.6270e-3,
            ],
            [
                1.9640e-3, 1.0900e-4, -1.1580e-3, 4.3540e-3, 3.4100e-4, 5.4330e-3,
            ],
            [
                1.2516e-2, -4.2800e-4, -1.1960e-3, 1.0027e-2, -7.4100e-4, 4.8150e-3,
            ],
        ]
        .map(tensor),
        g: 9.81,
    }
}

#[test]
fn it_moves_as_its_links() {
    let arm = panda();
    let links = std::array::from_fn(|i| Link {
        parent: i.checked_sub(1),
        place: arm.place[i],
        axes: Rotation3::from_axis_angle(&Vector3::x_axis(), arm.twist[i]),
        motion: Motion::Turn(Vector3::z()),
        mass: arm.m[i],
        center: arm.center[i],
        inertia: arm.inertia[i],
        rotor: 0.0,
    });
    let mut random = Random::default();
    let states: Vec<_> = (0..20).map(|_| random.state()).collect();
    assert_moves_as(&arm, &links, arm.g, &states);
}

/// Without its motors it swings, and keeps its energy.
#[test]
fn it_keeps_its_energy() {
    let arm = panda();
    let pose = [0.0, 0.4, -0.2, -1.5, 0.3, 1.0, 0.2];
    let start = State::new(0.0, pose, [0.0; 7]);
    let method = Dop853::new()
        .relative_tolerance(1e-12)
        .absolute_tolerance(1e-12);
    let end = Problem::new(&arm, start).solve(5.0, method).unwrap();
    let [before, after] = [start, end.last].map(|state| arm.energy(&state));
    assert!(relative_error(&[after], &[before], 1.0) < 1e-9);
}
