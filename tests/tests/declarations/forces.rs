//! Forces on positions do the work F·δp: the generalized forces are Q = Jᵀ F.

use lagrangian::nalgebra::Matrix2;
use lagrangian::prelude::*;
use lagrangian_tests::assert_close;

/// An arm of two links that is pushed at its tip, driven at its elbow against the ground, and slowed down by
/// the air at both masses.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(shoulder, elbow),
    define(
        forearm = shoulder + elbow,
        p[0] = l[0] * [cos(shoulder), sin(shoulder)],
        p[1] = p[0] + l[1] * [cos(forearm), sin(forearm)],
        shaken = p[1] + [0.1 * sin(t), 0.0],
    ),
    kinetic = (0..2).map(|i| 0.5 * m[i] * dot(p[i]).norm_squared()).sum(),
    force(shoulder = -stiffness * shoulder),
    force(shaken = push, forearm = torque),
    force(p[i] = -drag * dot(p[i]) for i in 0..2),
    output(tip = p[1], velocity = dot(p[1])),
)]
struct Arm {
    m: [f64; 2],
    l: [f64; 2],
    stiffness: f64,
    drag: f64,
    #[lagrangian(input)]
    push: Vector2<f64>,
    #[lagrangian(input)]
    torque: f64,
}

/// The air as a dissipation function instead.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(shoulder, elbow),
    define(
        p[0] = l[0] * [cos(shoulder), sin(shoulder)],
        p[1] = p[0] + l[1] * [cos(shoulder + elbow), sin(shoulder + elbow)],
    ),
    kinetic = (0..2).map(|i| 0.5 * m[i] * dot(p[i]).norm_squared()).sum(),
    dissipation = 0.5 * drag * (0..2).map(|i| dot(p[i]).norm_squared()).sum(),
)]
struct Slowed {
    m: [f64; 2],
    l: [f64; 2],
    drag: f64,
}

#[test]
fn forces_on_positions_do_their_work() {
    let (m, l, stiffness) = ([1.5, 0.75], [0.5, 0.4], 2.0);
    let (push, torque) = (Vector2::new(3.0, -1.25), 0.6);
    let drag = 0.35;
    let state = State::new(0.3, [0.4, 1.1], [1.7, -0.8]);
    let [shoulder, elbow] = [state.q[0], state.q[1]];
    let (sine, cosine) = (shoulder + elbow).sin_cos();
    let upper = Matrix2::new(-l[0] * shoulder.sin(), 0.0, l[0] * shoulder.cos(), 0.0);
    let lower = upper + l[1] * Matrix2::new(-sine, -sine, cosine, cosine);
    let air = Slowed { m, l, drag }.generalized_forces(&state);
    let slowed = -drag * (upper.transpose() * upper + lower.transpose() * lower) * state.v;
    assert_close("air", air.as_slice(), slowed.as_slice(), 1e-15);
    let expected =
        lower.transpose() * push + Vector2::new(torque - stiffness * shoulder, torque) + slowed;
    let arm = Arm {
        m,
        l,
        stiffness,
        drag,
        push,
        torque,
    };
    let found = arm.generalized_forces(&state);
    assert_close("Q", found.as_slice(), expected.as_slice(), 1e-15);
    // The power of the push is F·ṗ.
    let others = arm
        .with_inputs([0.0, 0.0, torque])
        .generalized_forces(&state);
    let power = (found - others).dot(&state.v);
    let velocity = arm.outputs(&state).velocity;
    assert_close("power", &[power], &[push.dot(&velocity)], 1e-14);
}

/// A bead on a rod that is turned, seen along the rod and across it.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(x),
    define(v = [dot(x), rate * x]),
    kinetic = 0.5 * m * v.norm_squared(),
    force(v = push),
)]
struct Bead {
    m: f64,
    rate: f64,
    push: Vector2<f64>,
}

#[test]
fn what_contains_a_velocity_is_a_velocity_as_a_whole() {
    let bead = Bead {
        m: 1.5,
        rate: 2.0,
        push: Vector2::new(3.0, 5.0),
    };
    let forces = bead.generalized_forces(&State::new(0.0, [0.7], [0.3]));
    // The hand that turns the rod holds against the push across it.
    assert_close("Q", forces.as_slice(), &[3.0], 1e-15);
}

/// Velocities in frames that move: each is A(q, t) q̇ + b(q, t).
#[derive(Lagrangian, Clone)]
#[lagrangian(
    coordinates(theta, x, y),
    define(
        r = rotation_z(rate * t.powi(2)) * rotation_y(theta),
        w = angular_velocity(r),
        carried = dot(r * [x, y, length]),
        belt = dot(x) + pull + [speed, 2.0][0],
        by_hand = [dot(x) - dot(rate * t) * y, dot(y) + dot(rate * t) * x],
        transported = dot([x, y, x * y]) + [pull, 0.0, rate].cross([x, y, x * y]),
        slider[0] = rate * x,
        slider[i] = x * y * dot(y) for i in 1..3,
    ),
    kinetic = 0.5 * w.dot(inertia * w) + 0.5 * (dot(x).powi(2) + dot(y).powi(2)),
    force(w = torque, carried = push + drag * carried, belt = pull * x),
    force(by_hand = [3.0, pull]),
    force(transported = [pull, 1.0, -2.0]),
    force(slider[i] = 0.5 + i for i in 0..2),
    output(w = w, carried = carried, belt = belt, by_hand = by_hand, transported = transported),
)]
struct Carried {
    inertia: Matrix3<f64>,
    rate: f64,
    speed: f64,
    length: f64,
    drag: f64,
    torque: Vector3<f64>,
    push: Vector3<f64>,
    #[lagrangian(input)]
    pull: f64,
}

#[test]
fn frames_that_move_do_not_take_part_in_virtual_power() {
    let model = Carried {
        inertia: Matrix3::new(2.0, 0.25, 0.0, 0.25, 3.0, -0.5, 0.0, -0.5, 4.0),
        rate: 2.0,
        speed: 0.6,
        length: 0.8,
        drag: -0.4,
        torque: Vector3::new(3.0, 5.0, 7.0),
        push: Vector3::new(-1.0, 0.75, 2.0),
        pull: 1.25,
    };
    let state = State::new(0.3, [0.7, 0.4, -0.9], [1.1, -0.6, 0.8]);
    let [_, x, y] = <[f64; 3]>::from(state.q);
    // Velocities are of first degree in q̇: differences give their slopes exactly.
    let expected = [0, 1, 2].map(|i| {
        let [mut ahead, mut behind] = [state; 2];
        ahead.v[i] += 0.5;
        behind.v[i] -= 0.5;
        let [ahead, behind] = [ahead, behind].map(|state| model.outputs(&state));
        let carried = model.outputs(&state).carried;
        let own = if i == 2 { 1.5 * x * y } else { 0.0 };
        model.torque.dot(&(ahead.w - behind.w))
            + (model.push + model.drag * carried).dot(&(ahead.carried - behind.carried))
            + model.pull * x * (ahead.belt - behind.belt)
            + Vector2::new(3.0, model.pull).dot(&(ahead.by_hand - behind.by_hand))
            + Vector3::new(model.pull, 1.0, -2.0).dot(&(ahead.transported - behind.transported))
            + own
    });
    let found = model.generalized_forces(&state);
    assert_close("Q", found.as_slice(), &expected, 1e-14);
    // About the axis of the hinge the torque is the component along it.
    let torque = |y: f64| {
        let mut model = model.clone();
        model.torque.y = y;
        model.generalized_forces(&state)[Carried::THETA]
    };
    assert_close("hinge", &[torque(5.0) - torque(0.0)], &[5.0], 1e-14);
}

/// A rigid body with a torque about its own axes, and with one about those of space; air slows it down.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(yaw, pitch, roll),
    define(
        r = rotation_zyx(yaw, pitch, roll),
        w = angular_velocity(r),
        w_space = angular_velocity_inertial(r),
    ),
    kinetic = 0.5 * w.dot(inertia * w),
    force(w = torque - drag * w.norm() * w),
    force(w_space = wind),
    output(w = w, rate = dot(w), r = r),
)]
struct Body {
    inertia: Matrix3<f64>,
    torque: Vector3<f64>,
    wind: Vector3<f64>,
    drag: f64,
}

#[test]
fn forces_on_velocities_give_power_with_them() {
    let inertia = Matrix3::new(2.0, 0.25, 0.0, 0.25, 3.0, -0.5, 0.0, -0.5, 4.0);
    let body = Body {
        inertia,
        torque: Vector3::new(0.5, -1.0, 2.0),
        wind: Vector3::new(-0.75, 0.25, 1.5),
        drag: 0.3,
    };
    for q in [[0.4, 0.7, -1.2], [-2.0, -0.3, 0.9]] {
        let state = State::new(0.0, q, [1.1, -0.6, 0.8]);
        let BodyOutputs { w, rate, r } = body.outputs(&state);
        let torque = body.torque - body.drag * w.norm() * w + r.transpose() * body.wind;
        // Euler's equations (3.5)-(3.7): I ω̇ + ω × Iω = τ in the axes of the body.
        let found = inertia * rate + w.cross(&(inertia * w));
        assert_close(
            "Euler's equations",
            found.as_slice(),
            torque.as_slice(),
            1e-13,
        );
        let power = body.generalized_forces(&state).dot(&state.v);
        assert_close("power", &[power], &[torque.dot(&w)], 1e-13);
    }
}

/// A pendulum that nothing drives or slows down.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(theta),
    kinetic = 0.5 * m * (l * dot(theta)).powi(2),
    potential = -m * g * l * cos(theta),
)]
struct Free {
    m: f64,
    g: f64,
    l: f64,
}

#[test]
fn a_model_without_forces_has_zeros() {
    let pendulum = Free {
        m: 0.4,
        g: 9.81,
        l: 1.3,
    };
    let state: State<f64, 1> = State::new(0.3, [0.7], [1.1]);
    assert_eq!(pendulum.generalized_forces(&state)[0].to_bits(), 0);
    assert_eq!(pendulum.power(&state).to_bits(), 0);
}
