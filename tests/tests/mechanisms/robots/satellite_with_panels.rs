//! A satellite in free flight with two panels on hinges with springs: its momenta are kept.

use lagrangian::prelude::*;
use lagrangian_tests::Random;
use nalgebra::{Matrix3, Vector3};

use super::recursion::{Link, Motion, assert_moves_as};

#[derive(Lagrangian)]
#[lagrangian(
    coordinates(x: Vector3, a[3], q[2]),
    define(
        hub = rotation_xyz(a[0], a[1], a[2]),
        panel[i] = hub * rotation_y(q[i]) for i in 0..2,
        c[i] = x + hub * [0.0, side[i] * mount, 0.0] + panel[i] * [0.0, side[i] * half, sag] for i in 0..2,
        w = angular_velocity(hub),
        u[i] = angular_velocity(panel[i]) for i in 0..2,
        at = hub * w,
    ),
    kinetic = 0.5 * m_hub * dot(x).norm_squared() + 0.5 * w.dot(inertia_hub * w),
    kinetic = (0..2).map(|i| {
        0.5 * m_panel * dot(c[i]).norm_squared() + 0.5 * u[i].dot(inertia_panel * u[i])
    }).sum(),
    potential = (0..2).map(|i| 0.5 * stiffness * q[i].powi(2)).sum(),
    output(
        momentum = x.cross(m_hub * dot(x)) + hub * (inertia_hub * w) + (0..2).map(|i| {
            c[i].cross(m_panel * dot(c[i])) + panel[i] * (inertia_panel * u[i])
        }).sum(),
        spin = at.norm(),
    ),
)]
struct Satellite {
    side: [f64; 2],
    mount: f64,
    half: f64,
    sag: f64,
    m_hub: f64,
    inertia_hub: Matrix3<f64>,
    m_panel: f64,
    inertia_panel: Matrix3<f64>,
    stiffness: f64,
}

fn satellite() -> Satellite {
    Satellite {
        side: [1.0, -1.0],
        mount: 0.6,
        half: 1.1,
        sag: 0.05,
        m_hub: 120.0,
        inertia_hub: Matrix3::new(20.0, 1.0, -0.5, 1.0, 24.0, 0.3, -0.5, 0.3, 16.0),
        m_panel: 8.0,
        inertia_panel: Matrix3::new(3.4, 0.1, 0.0, 0.1, 0.5, 0.0, 0.0, 0.0, 3.8),
        stiffness: 0.0,
    }
}

fn start() -> State<f64, 8> {
    let mut random = Random::default();
    let mut state = random.state();
    (state.t, state.q[4]) = (0.0, 0.3);
    state.v *= 0.3;
    state
}

#[test]
fn it_moves_as_its_links() {
    let satellite = satellite();
    let [x, y, z] = [Vector3::x(), Vector3::y(), Vector3::z()];
    let motions = [
        Motion::Slide(x),
        Motion::Slide(y),
        Motion::Slide(z),
        Motion::Turn(x),
        Motion::Turn(y),
        Motion::Turn(z),
        Motion::Turn(y),
        Motion::Turn(y),
    ];
    let mut links: [Link; 8] = std::array::from_fn(|i| {
        let parent = if i < 6 { i.checked_sub(1) } else { Some(5) };
        Link::massless(parent, Vector3::zeros(), motions[i])
    });
    (links[5].mass, links[5].inertia) = (satellite.m_hub, satellite.inertia_hub);
    for (link, side) in links[6..].iter_mut().zip(satellite.side) {
        link.place = Vector3::new(0.0, side * satellite.mount, 0.0);
        link.mass = satellite.m_panel;
        link.center = Vector3::new(0.0, side * satellite.half, satellite.sag);
        link.inertia = satellite.inertia_panel;
    }
    let mut random = Random::default();
    let states = (0..20).map(|_| {
        let mut state = random.state();
        state.q[4] *= 0.3;
        state
    });
    assert_moves_as(&satellite, &links, 0.0, &states.collect::<Vec<_>>());
}

#[test]
fn it_keeps_its_momenta_and_its_energy() {
    let satellite = Satellite {
        stiffness: 3.0,
        ..satellite()
    };
    let method = Dop853::new()
        .relative_tolerance(1e-12)
        .absolute_tolerance(1e-12);
    let start = start();
    let end = Problem::new(&satellite, start).solve(10.0, method).unwrap();
    let [before, after] = [start, end.last].map(|state| {
        let outputs = satellite.outputs(&state);
        (satellite.energy(&state), outputs.momentum, outputs.spin)
    });
    assert!(
        (after.0 / before.0 - 1.0).abs() < 1e-10,
        "{before:?} {after:?}"
    );
    assert!((after.1 - before.1).norm() < 1e-9 * before.1.norm());
    // The hub does not turn as it did: the panels swing.
    assert!((after.2 - before.2).abs() > 1e-3);
}
