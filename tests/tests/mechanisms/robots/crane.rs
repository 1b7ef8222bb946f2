//! A tower crane: a jib that turns, a trolley on it, and a load on a rope that is hauled in, swinging in both directions.

use lagrangian::prelude::*;
use lagrangian_tests::Random;
use nalgebra::{Matrix3, Vector3};

use super::recursion::{Link, Motion, assert_moves_as};

/// The drum of the hoist turns with the rope.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(turn, reach, swing, lean, rope),
    define(
        jib = rotation_z(turn),
        hook = jib * rotation_y(swing) * rotation_x(lean),
        trolley = jib * [reach, 0.0, height],
        load = trolley + hook * [0.0, 0.0, -rope],
        w = angular_velocity(hook),
    ),
    kinetic = 0.5 * i_jib * dot(turn).powi(2) + 0.5 * m_trolley * dot(trolley).norm_squared(),
    kinetic = 0.5 * m_load * dot(load).norm_squared() + 0.5 * w.dot(inertia * w),
    kinetic = 0.5 * i_drum * (dot(rope) / radius).powi(2),
    potential = g * (m_trolley * trolley.z + m_load * load.z),
)]
struct Crane {
    i_jib: f64,
    height: f64,
    m_trolley: f64,
    m_load: f64,
    inertia: Matrix3<f64>,
    i_drum: f64,
    radius: f64,
    g: f64,
}

#[test]
fn it_moves_as_its_links() {
    let crane = Crane {
        i_jib: 9e4,
        height: 30.0,
        m_trolley: 600.0,
        m_load: 2000.0,
        inertia: Matrix3::new(900.0, 30.0, 0.0, 30.0, 700.0, -20.0, 0.0, -20.0, 400.0),
        i_drum: 50.0,
        radius: 0.4,
        g: 9.81,
    };
    let [x, y, z] = [Vector3::x(), Vector3::y(), Vector3::z()];
    let none = Vector3::zeros();
    let up = Vector3::new(0.0, 0.0, crane.height);
    let mut links = [
        Link::massless(None, up, Motion::Turn(z)),
        Link::massless(Some(0), none, Motion::Slide(x)),
        Link::massless(Some(1), none, Motion::Turn(y)),
        Link::massless(Some(2), none, Motion::Turn(x)),
        Link::massless(Some(3), none, Motion::Slide(-z)),
    ];
    links[0].inertia[(2, 2)] = crane.i_jib;
    links[1].mass = crane.m_trolley;
    links[4].mass = crane.m_load;
    links[4].inertia = crane.inertia;
    links[4].rotor = crane.i_drum / crane.radius.powi(2);
    let mut random = Random::default();
    let states = (0..20).map(|_| {
        let mut state = random.state();
        state.q[1] = random.between(5.0, 20.0);
        state.q[3] *= 0.3;
        state.q[4] = random.between(5.0, 25.0);
        state
    });
    assert_moves_as(&crane, &links, crane.g, &states.collect::<Vec<_>>());
}
