//! The quadruped Solo of the Open Dynamic Robot Initiative (Grimminger and others, An open torque-controlled modular robot
//! architecture for legged locomotion research, 2020), with twelve motors and a free base: 18 degrees of freedom.

use lagrangian::prelude::*;
use lagrangian_tests::Random;
use nalgebra::{Matrix3, Rotation3, Vector3};

use super::recursion::{Link, Motion, assert_moves_as};

/// Each leg has a shoulder that turns about x, and an upper and a lower leg that turn about y. `side` is 1 on the left and −1
/// on the right, `end` 1 in front and −1 behind.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(x: Vector3, a[3], q[4][3]),
    define(
        base = rotation_zyx(a[0], a[1], a[2]),
        turn = angular_velocity(base),
        shoulder[i] = base * rotation_x(q[i][0]) for i in 0..4,
        upper[i] = shoulder[i] * rotation_y(q[i][1]) for i in 0..4,
        lower[i] = upper[i] * rotation_y(q[i][2]) for i in 0..4,
        hip[i] = x + base * [0.19 * end[i], 0.1046 * side[i], 0.0] for i in 0..4,
        knee[i] = hip[i] + upper[i] * [0.0, 0.03745 * side[i], -0.16] for i in 0..4,
        upper_center[i] = hip[i] + upper[i] * [x_upper * side[i], y_upper * side[i], z_upper] for i in 0..4,
        lower_center[i] = knee[i] + lower[i] * [0.0, y_lower * side[i], z_lower] for i in 0..4,
        w_upper[i] = angular_velocity(upper[i]) for i in 0..4,
        w_lower[i] = angular_velocity(lower[i]) for i in 0..4,
    ),
    kinetic = 0.5 * m_base * dot(x).norm_squared() + 0.5 * turn.dot(inertia_base.component_mul(turn)),
    kinetic = (0..4).map(|i| {
        0.5 * m_shoulder * dot(hip[i]).norm_squared()
            + 0.5 * m_upper * dot(upper_center[i]).norm_squared()
            + 0.5 * m_lower * dot(lower_center[i]).norm_squared()
            + 0.5 * w_upper[i].dot(inertia_upper.component_mul(w_upper[i]))
            + 0.5 * w_lower[i].dot(inertia_lower.component_mul(w_lower[i]))
            - side[i] * product_upper * w_upper[i].y * w_upper[i].z
            - side[i] * product_lower * w_lower[i].y * w_lower[i].z
    }).sum(),
    potential = m_base * g * x.z + (0..4).map(|i| {
        g * (m_shoulder * hip[i].z + m_upper * upper_center[i].z + m_lower * lower_center[i].z)
    }).sum(),
)]
struct Solo12 {
    end: [f64; 4],
    side: [f64; 4],
    m_base: f64,
    inertia_base: Vector3<f64>,
    m_shoulder: f64,
    m_upper: f64,
    x_upper: f64,
    y_upper: f64,
    z_upper: f64,
    inertia_upper: Vector3<f64>,
    /// The product of inertia +∫yz dm of a left leg.
    product_upper: f64,
    m_lower: f64,
    y_lower: f64,
    z_lower: f64,
    inertia_lower: Vector3<f64>,
    product_lower: f64,
    g: f64,
}

fn solo() -> Solo12 {
    Solo12 {
        end: [1.0, 1.0, -1.0, -1.0],
        side: [1.0, -1.0, 1.0, -1.0],
        m_base: 1.633_150_91,
        inertia_base: Vector3::new(0.005_785_74, 0.019_381_08, 0.024_761_24),
        m_shoulder: 0.15,
        m_upper: 0.148_538_45,
        x_upper: 0.000_013_77,
        y_upper: 0.019_358_53,
        z_upper: -0.078_707,
        inertia_upper: Vector3::new(0.000_411_07, 0.000_411_93, 0.000_030_24),
        product_upper: -0.000_046_71,
        m_lower: 0.030_700_01,
        y_lower: 0.007_876_44,
        z_lower: -0.089_282_15,
        inertia_lower: Vector3::new(0.000_120_24, 0.000_120_29, 0.000_002_16),
        product_lower: -0.000_003_05,
        g: 9.81,
    }
}

/// Six joints of the base, and three of each leg.
fn links(solo: &Solo12) -> [Link; 18] {
    let [x, y, z] = [Vector3::x(), Vector3::y(), Vector3::z()];
    let none = Vector3::zeros();
    let base = [
        Motion::Slide(x),
        Motion::Slide(y),
        Motion::Slide(z),
        Motion::Turn(z),
        Motion::Turn(y),
        Motion::Turn(x),
    ];
    std::array::from_fn(|i| {
        let Some(joint) = i.checked_sub(6) else {
            let link = Link::massless(i.checked_sub(1), none, base[i]);
            return if i < 5 {
                link
            } else {
                Link {
                    mass: solo.m_base,
                    inertia: Matrix3::from_diagonal(&solo.inertia_base),
                    ..link
                }
            };
        };
        let (leg, end, side) = (joint / 3, solo.end[joint / 3], solo.side[joint / 3]);
        let tensor = |diagonal: Vector3<f64>, product: f64| {
            let mut tensor = Matrix3::from_diagonal(&diagonal);
            tensor[(1, 2)] = -side * product;
            tensor[(2, 1)] = -side * product;
            tensor
        };
        let (parent, place, motion, mass, center, inertia) = match joint % 3 {
            0 => {
                let hip = Vector3::new(0.19 * end, 0.1046 * side, 0.0);
                let still = (solo.m_shoulder, none, Matrix3::zeros());
                (5, hip, Motion::Turn(x), still.0, still.1, still.2)
            }
            1 => {
                let center = Vector3::new(solo.x_upper * side, solo.y_upper * side, solo.z_upper);
                let inertia = tensor(solo.inertia_upper, solo.product_upper);
                (
                    6 + 3 * leg,
                    none,
                    Motion::Turn(y),
                    solo.m_upper,
                    center,
                    inertia,
                )
            }
            _ => {
                let knee = Vector3::new(0.0, 0.03745 * side, -0.16);
                let center = Vector3::new(0.0, solo.y_lower * side, solo.z_lower);
                let inertia = tensor(solo.inertia_lower, solo.product_lower);
                (
                    7 + 3 * leg,
                    knee,
                    Motion::Turn(y),
                    solo.m_lower,
                    center,
                    inertia,
                )
            }
        };
        Link {
            parent: Some(parent),
            place,
            axes: Rotation3::identity(),
            motion,
            mass,
            center,
            inertia,
            rotor: 0.0,
        }
    })
}

#[test]
fn it_moves_as_its_links() {
    let solo = solo();
    let mut random = Random::default();
    let states = (0..10).map(|_| {
        let mut state = random.state();
        // Away from the pole of the angles of the base.
        state.q[4] *= 0.3;
        state
    });
    assert_moves_as(&solo, &links(&solo), solo.g, &states.collect::<Vec<_>>());
}

/// In flight its momentum about its centre of mass is kept, and so are its energy and horizontal momentum.
#[test]
fn in_flight_it_keeps_its_momenta() {
    let solo = solo();
    let mut random = Random::default();
    let mut start = random.state();
    (start.t, start.q[4]) = (0.0, 0.2);
    start.v *= 0.5;
    let method = Dop853::new()
        .relative_tolerance(1e-12)
        .absolute_tolerance(1e-12);
    let end = Problem::new(&solo, start).solve(0.5, method).unwrap();
    let [before, after] = [start, end.last].map(|state| {
        let p = solo.momenta(&state);
        [solo.energy(&state), p[0], p[1], p[2]]
    });
    let mass = solo.m_base + 4.0 * (solo.m_shoulder + solo.m_upper + solo.m_lower);
    let fallen = before[3] - mass * solo.g * 0.5;
    assert!((after[0] - before[0]).abs() < 1e-9, "{before:?} {after:?}");
    assert!((after[1] - before[1]).abs() < 1e-10);
    assert!((after[2] - before[2]).abs() < 1e-10);
    assert!((after[3] - fallen).abs() < 1e-10);
}
