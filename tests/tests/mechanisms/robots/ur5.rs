//! The UR5 of Universal Robots, with the lengths, masses and inertias of its published robot description.

use core::f64::consts::FRAC_PI_2;

use lagrangian::prelude::*;
use lagrangian_tests::Random;
use nalgebra::{Matrix3, Rotation3, Vector3};

use super::recursion::{Link, Motion, assert_moves_as};

/// Constants stand in the declaration, as in the robot description.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(q[6]),
    define(
        r[0] = rotation_z(q[0]),
        r[1] = r[0] * rotation_y(PI / 2 + q[1]),
        r[2] = r[1] * rotation_y(q[2]),
        r[3] = r[2] * rotation_y(PI / 2 + q[3]),
        r[4] = r[3] * rotation_z(q[4]),
        r[5] = r[4] * rotation_y(q[5]),
        p[0] = [0.0, 0.0, 0.089159],
        p[1] = p[0] + r[0] * [0.0, 0.13585, 0.0],
        p[2] = p[1] + r[1] * [0.0, -0.1197, 0.425],
        p[3] = p[2] + r[2] * [0.0, 0.0, 0.39225],
        p[4] = p[3] + r[3] * [0.0, 0.093, 0.0],
        p[5] = p[4] + r[4] * [0.0, 0.0, 0.09465],
        c[i] = p[i] + r[i] * [0.0, 0.0, center[i]] for i in 0..6,
        w[i] = angular_velocity(r[i]) for i in 0..6,
    ),
    kinetic = (0..6).map(|i| {
        0.5 * m[i] * dot(c[i]).norm_squared()
            + 0.5 * (across[i] * (w[i].x.powi(2) + w[i].y.powi(2)) + along[i] * w[i].z.powi(2))
    }).sum(),
    potential = (0..6).map(|i| m[i] * g * c[i].z).sum(),
    taylor,
)]
struct Ur5 {
    m: [f64; 6],
    center: [f64; 6],
    across: [f64; 6],
    along: [f64; 6],
    g: f64,
}

fn ur5() -> Ur5 {
    let wrist = 0.111_172_755_531;
    Ur5 {
        m: [3.7, 8.393, 2.275, 1.219, 1.219, 0.1879],
        center: [0.0, 0.28, 0.25, 0.0, 0.0, 0.0],
        across: [
            0.010_267_495_893,
            0.226_890_675_91,
            0.049_443_313_556,
            wrist,
            wrist,
            0.017_136_473_145_4,
        ],
        along: [0.00666, 0.015_107_4, 0.004_095, 0.21942, 0.21942, 0.033_822],
        g: 9.81,
    }
}

#[test]
fn it_moves_as_its_links() {
    let arm = ur5();
    let places = [
        [0.0, 0.0, 0.089_159],
        [0.0, 0.13585, 0.0],
        [0.0, -0.1197, 0.425],
        [0.0, 0.0, 0.39225],
        [0.0, 0.093, 0.0],
        [0.0, 0.0, 0.09465],
    ];
    let (y, z) = (Vector3::y(), Vector3::z());
    let directions = [z, y, y, y, z, y];
    let links = std::array::from_fn(|i| {
        let angle = if i == 1 || i == 3 { FRAC_PI_2 } else { 0.0 };
        let (across, along) = (arm.across[i], arm.along[i]);
        Link {
            parent: i.checked_sub(1),
            place: Vector3::from(places[i]),
            axes: Rotation3::from_axis_angle(&Vector3::y_axis(), angle),
            motion: Motion::Turn(directions[i]),
            mass: arm.m[i],
            center: Vector3::new(0.0, 0.0, arm.center[i]),
            inertia: Matrix3::from_diagonal(&Vector3::new(across, across, along)),
            rotor: 0.0,
        }
    });
    let mut random = Random::default();
    let states: Vec<_> = (0..20).map(|_| random.state()).collect();
    assert_moves_as(&arm, &links, arm.g, &states);
}

/// Swinging from rest, by the Taylor series along the links and by Runge and Kutta's method with tight tolerances.
#[test]
fn its_series_moves_it() {
    let arm = ur5();
    let start = State::new(0.0, [0.3, 0.4, -0.7, 0.2, 0.5, 0.1], [0.0; 6]);
    let found = Problem::new(&arm, start).solve(1.0, Taylor::new()).unwrap();
    let tight = Dop853::new()
        .relative_tolerance(1e-14)
        .absolute_tolerance(1e-14);
    let expected = Problem::new(&arm, start).solve(1.0, tight).unwrap();
    let [found, expected] = [found.last, expected.last];
    assert!((found.q - start.q).norm() > 0.5, "it moves: {found:?}");
    assert!((found.q - expected.q).norm() < 1e-11, "{found:?}");
    assert!((found.v - expected.v).norm() < 1e-10, "{found:?}");
}

#[test]
#[ignore = "a long motion; run with `--include-ignored`"]
fn its_series_keeps_its_energy_for_long() {
    keep_energy(100.0);
}

#[test]
fn its_series_keeps_its_energy() {
    keep_energy(10.0);
}

fn keep_energy(time: f64) {
    let arm = ur5();
    let start = State::new(0.0, [0.3, 0.4, -0.7, 0.2, 0.5, 0.1], [0.0; 6]);
    let energy = arm.energy(&start);
    // The size of the energy that is exchanged is that of the kinetic one.
    let state = Problem::new(&arm, start)
        .solve(time, Taylor::new())
        .unwrap();
    let size = 0.5 * state.v.dot(&(arm.mass_matrix(&state) * state.v)) + energy.abs();
    let drift = (arm.energy(&state) - energy).abs() / size;
    assert!(drift < 1e-12, "{drift:e}");
}
