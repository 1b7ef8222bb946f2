//! The Puma 560 with its motors, from the table of Corke and Armstrong-Hélouvry (A search for consensus among model
//! parameters reported for the PUMA 560 robot, 1994) as Corke, Robotics, Vision and Control, 2017, section 9, has it.

use core::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI};

use lagrangian::prelude::*;
use lagrangian_tests::Random;
use nalgebra::{Matrix3, Rotation3, SVector, Vector3};

use super::recursion::{Link, Motion, assert_moves_as};

/// Rotations and places by the parameters of Denavit and Hartenberg; motors with their inertia, viscous and dry friction
/// seen through their gears.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(q[6]),
    define(
        a[i] = rotation_z(q[i]) * rotation_x(twist[i]) for i in 0..6,
        r[0] = a[0],
        r[i] = r[i - 1] * a[i] for i in 1..6,
        along[i] = rotation_z(q[i]) * [length[i], 0.0, offset[i]] for i in 0..6,
        p[0] = along[0],
        p[i] = p[i - 1] + r[i - 1] * along[i] for i in 1..6,
        c[i] = p[i] + r[i] * center[i] for i in 0..6,
        w[i] = angular_velocity(r[i]) for i in 0..6,
        motor[i] = gear[i] * dot(q[i]) for i in 0..6,
    ),
    kinetic = (0..6).map(|i| {
        0.5 * m[i] * dot(c[i]).norm_squared() + 0.5 * w[i].dot(inertia[i] * w[i])
    }).sum(),
    kinetic = (0..6).map(|i| 0.5 * rotor[i] * motor[i].powi(2)).sum(),
    potential = (0..6).map(|i| m[i] * g * c[i].z).sum(),
    dissipation = (0..6).map(|i| 0.5 * viscous[i] * motor[i].powi(2)).sum(),
    force(q[i] = -dry[i] * abs(gear[i]) * signum(dot(q[i])) for i in 0..6),
)]
struct Puma560 {
    twist: [f64; 6],
    length: [f64; 6],
    offset: [f64; 6],
    m: [f64; 6],
    center: [Vector3<f64>; 6],
    inertia: [Matrix3<f64>; 6],
    rotor: [f64; 6],
    gear: [f64; 6],
    viscous: [f64; 6],
    dry: [f64; 6],
    g: f64,
}

fn puma() -> Puma560 {
    let diagonal = |x, y, z| Matrix3::from_diagonal(&Vector3::new(x, y, z));
    Puma560 {
        twist: [FRAC_PI_2, 0.0, -FRAC_PI_2, FRAC_PI_2, -FRAC_PI_2, 0.0],
        length: [0.0, 0.4318, 0.0203, 0.0, 0.0, 0.0],
        offset: [0.0, 0.0, 0.15005, 0.4318, 0.0, 0.0],
        m: [0.0, 17.4, 4.8, 0.82, 0.34, 0.09],
        center: [
            Vector3::zeros(),
            Vector3::new(-0.3638, 0.006, 0.2275),
            Vector3::new(-0.0203, -0.0141, 0.070),
            Vector3::new(0.0, 0.019, 0.0),
            Vector3::zeros(),
            Vector3::new(0.0, 0.0, 0.032),
        ],
        inertia: [
            diagonal(0.0, 0.35, 0.0),
            diagonal(0.13, 0.524, 0.539),
            diagonal(0.066, 0.086, 0.0125),
            diagonal(1.8e-3, 1.3e-3, 1.8e-3),
            diagonal(0.3e-3, 0.4e-3, 0.3e-3),
            diagonal(0.15e-3, 0.15e-3, 0.04e-3),
        ],
        rotor: [200e-6, 200e-6, 200e-6, 33e-6, 33e-6, 33e-6],
        gear: [-62.6111, 107.815, -53.7063, 76.0364, 71.923, 76.686],
        viscous: [1.48e-3, 0.817e-3, 1.38e-3, 71.2e-6, 82.6e-6, 36.7e-6],
        dry: [0.395, 0.126, 0.132, 11.2e-3, 9.26e-3, 3.96e-3],
        g: 9.81,
    }
}

/// The torques that Corke's toolbox prints for the nominal pose (`test_rne` of its Python edition): at rest, at unit
/// velocities, and with unit accelerations besides.
#[test]
fn torques_are_those_that_were_published() {
    let pose = [0.0, FRAC_PI_4, PI, 0.0, FRAC_PI_4, 0.0];
    for (velocity, acceleration, expected) in [
        (0.0, 0.0, [0.0, 31.6399, 6.0351, 0.0, 0.0283, 0.0]),
        (
            1.0,
            0.0,
            [29.1421, 56.5044, 16.3528, 1.2645, 1.1239, 0.5196],
        ),
        (
            1.0,
            1.0,
            [32.4952, 60.8670, 17.7436, 1.4545, 1.2991, 0.7138],
        ),
    ] {
        let state = State::new(0.0, pose, [velocity; 6]);
        let found = puma().inverse_dynamics(&state, &SVector::from([acceleration; 6]));
        for (x, y) in found.iter().zip(expected) {
            assert!((x - y).abs() < 6e-5, "{found} is not {expected:?}");
        }
    }
}

#[test]
fn it_moves_as_its_links() {
    let mut puma = puma();
    (puma.viscous, puma.dry) = ([0.0; 6], [0.0; 6]);
    // Joint i turns about z of the axes before, which are then moved and twisted.
    let links = std::array::from_fn(|i| {
        let into = |k: usize| Rotation3::from_axis_angle(&Vector3::x_axis(), puma.twist[k]);
        let moved = |k: usize| Vector3::new(puma.length[k], 0.0, puma.offset[k]);
        let own = into(i);
        Link {
            parent: i.checked_sub(1),
            place: if i == 0 {
                Vector3::zeros()
            } else {
                moved(i - 1)
            },
            axes: if i == 0 {
                Rotation3::identity()
            } else {
                into(i - 1)
            },
            motion: Motion::Turn(Vector3::z()),
            mass: puma.m[i],
            center: moved(i) + own * puma.center[i],
            inertia: own * puma.inertia[i] * own.inverse(),
            rotor: puma.rotor[i] * puma.gear[i].powi(2),
        }
    });
    let mut random = Random::default();
    let states: Vec<_> = (0..20).map(|_| random.state()).collect();
    assert_moves_as(&puma, &links, puma.g, &states);
}
