//! Reactions as outputs and in events.

use lagrangian::nalgebra::{Rotation3, Vector3};
use lagrangian::prelude::*;
use lagrangian::rigid_body::PrincipalBody;
use lagrangian_tests::assert_close;

/// A bead on the outside of a smooth sphere, which it leaves where the reaction vanishes: at cos θ = 2/3 from the top.
#[derive(Clone, Lagrangian)]
#[lagrangian(
    coordinates(x, y),
    kinetic = 0.5 * m * (dot(x).powi(2) + dot(y).powi(2)),
    potential = m * g * y,
    constraint(sphere = [x, y].norm() - r),
    output(normal = reaction(sphere)),
    event(leaves = reaction(sphere)),
    taylor,
)]
struct Bead {
    m: f64,
    g: f64,
    r: f64,
}

const BEAD: Bead = Bead {
    m: 0.3,
    g: 9.81,
    r: 2.0,
};

#[test]
fn a_bead_leaves_a_sphere_where_the_reaction_vanishes() -> Result<(), IntegrationError> {
    // From rest at θ₀ it leaves where 3 cos θ = 2 cos θ₀ (Goldstein, Classical Mechanics, 1980, derivation 2.13).
    let theta = 0.1_f64;
    let start = State::new(0.0, [BEAD.r * theta.sin(), BEAD.r * theta.cos()], [0.0; 2]);
    assert!((BEAD.outputs(&start).normal - BEAD.m * BEAD.g * theta.cos()).abs() < 1e-14);
    let expected = BEAD.r * 2.0 * theta.cos() / 3.0;
    let taylor = Problem::new(&BEAD, start)
        .on([Bead::LEAVES])
        .falling()
        .stop()
        .solve(10.0, Taylor::new())?;
    let dop853 = Problem::new(&BEAD, start)
        .on([Bead::LEAVES])
        .falling()
        .stop()
        .solve(10.0, Dop853::new())?;
    for end in [taylor.last, dop853.last] {
        assert!(
            (end.q[1] - expected).abs() < 1e-8,
            "{} {expected}",
            end.q[1]
        );
        assert!(BEAD.multipliers(&end)[0].abs() < 1e-8);
    }
    Ok(())
}

/// A door on a hinge along z at its edge, with its centre of gravity at p. In the axes of the room, all that acts on the door are its
/// weight, the force of the pin, and the moment of both constraints about its centre.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(x, y, z, a, b, c),
    define(
        p = [x, y, z],
        r = rotation_zyx(a, b, c),
        knob = p + r * [width, 0.0, 0.0],
    ),
    kinetic = kinetic_energy(door, r, p),
    potential = potential_energy(door, r, p, [0.0, g, -g]),
    force(knob = push),
    constraint(
        pin = p + r * edge,
        axis = [r.column(0).dot(post), r.column(1).dot(post)],
    ),
    output(
        hinge = reaction(pin, p),
        moment = reaction(pin, r) + reaction(axis, r),
        in_axes_of_the_door = r.transpose() * reaction(pin, p),
        lambda = reaction(pin),
        change_of_momentum = door.mass * dot(dot(p)),
        change_of_angular_momentum = dot(r * (door.inertia * angular_velocity(r))),
        arm = r * edge,
        lever = knob - p,
    ),
)]
struct HungDoor {
    door: PrincipalBody<f64>,
    edge: Vector3<f64>,
    width: f64,
    g: f64,
    post: Vector3<f64>,
    push: Vector3<f64>,
}

#[test]
fn forces_and_moments_of_a_hinge_balance_the_momenta() {
    let door = HungDoor {
        door: PrincipalBody::new(20.0, [0.9, 1.7, 2.5]).expect("it is a body"),
        edge: Vector3::new(-0.4, 0.02, 0.3),
        width: 0.45,
        g: 9.81,
        post: Vector3::z(),
        push: Vector3::new(3.0, -7.0, 2.0),
    };
    let angle = 0.7;
    let turn = Rotation3::from_axis_angle(&Vector3::z_axis(), angle);
    let place = -(turn * door.edge);
    let guess = State::new(
        0.0,
        [place.x, place.y, place.z, angle, 0.0, 0.0],
        [0.0, 0.0, 0.0, 2.5, 0.0, 0.0],
    );
    let found = door
        .assemble(guess)
        .hold([HungDoor::A])
        .hold_velocities([HungDoor::A]);
    let state = found.solve().expect("it is near its hinge").state;
    let seen = door.outputs(&state);
    let weight = 20.0 * Vector3::new(0.0, 9.81, -9.81);
    let force: Vector3<f64> = seen.change_of_momentum - weight - door.push;
    assert_close("force", seen.hinge.as_slice(), force.as_slice(), 1e-13);
    assert_close("λ", seen.lambda.as_slice(), force.as_slice(), 1e-13);
    let in_axes: Vector3<f64> = turn.inverse() * force;
    let found = seen.in_axes_of_the_door;
    assert_close("in its axes", found.as_slice(), in_axes.as_slice(), 1e-13);
    let moment = seen.change_of_angular_momentum - seen.lever.cross(&door.push);
    assert_close("moment", seen.moment.as_slice(), moment.as_slice(), 1e-12);
    // The hinge takes no moment about its axis: about the centre of the door it is that of the force of the pin alone.
    let about_post = seen.arm.cross(&force).z;
    assert_close("about the axis", &[seen.moment.z], &[about_post], 1e-12);
}

/// A ball that rolls on a table, and is pushed at its centre: friction acts on its lowest point.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(x, y, a, b, c),
    define(
        p = [x, y, radius],
        r = rotation_zxz(a, b, c),
        contact = dot(p) + angular_velocity_inertial(r).cross([0.0, 0.0, -radius]),
    ),
    kinetic = kinetic_energy(ball, r, p),
    force(p = [push, 0.0, 0.0]),
    nonholonomic(rolling = [contact.x, contact.y]),
    output(
        friction = reaction(rolling, p),
        moment = reaction(rolling, r),
        change_of_momentum = ball.mass * dot(dot(p)),
        change_of_angular_momentum = dot(r * (ball.inertia * angular_velocity(r))),
    ),
)]
struct RollingBall {
    ball: PrincipalBody<f64>,
    radius: f64,
    push: f64,
}

#[test]
fn friction_balances_the_momenta_of_a_rolling_ball() {
    let ball = RollingBall {
        ball: PrincipalBody::new(3.0, [0.02, 0.03, 0.04]).expect("it is a body"),
        radius: 0.1,
        push: 2.0,
    };
    let guess = State::new(0.0, [0.0, 0.0, 0.4, 1.1, -0.3], [0.0, 0.0, 0.5, 2.0, -1.0]);
    let held = [RollingBall::A, RollingBall::B, RollingBall::C];
    let found = ball.assemble(guess).hold(held).hold_velocities(held);
    let state = found
        .solve()
        .expect("the speed of its centre is free")
        .state;
    let seen = ball.outputs(&state);
    let friction: Vector3<f64> = seen.change_of_momentum - Vector3::new(2.0, 0.0, 0.0);
    assert_close(
        "friction",
        seen.friction.as_slice(),
        friction.as_slice(),
        1e-13,
    );
    let moment = seen.change_of_angular_momentum;
    assert_close("moment", seen.moment.as_slice(), moment.as_slice(), 1e-13);
    let lever = Vector3::new(0.0, 0.0, -0.1).cross(&friction);
    assert_close("lever", seen.moment.as_slice(), lever.as_slice(), 1e-13);
}

/// A slider-crank in the plane: the joint is a force on the end of the rod, and moments on both angles.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(crank, rod, slider),
    define(
        pin = [a * cos(crank), a * sin(crank)],
        end = pin + [l * cos(rod), l * sin(rod)],
        seat = [slider, 0.0],
    ),
    kinetic = 0.5 * i * dot(crank).powi(2) + 0.5 * m * dot(end).norm_squared() + 0.5 * n * dot(slider).powi(2),
    constraint(joint = end - seat),
    output(
        on_the_rod = reaction(joint, end),
        on_the_slider = reaction(joint, slider),
        on_the_crank = reaction(joint, crank),
        about_the_pin = reaction(joint, rod),
        whole = reaction(joint),
    ),
)]
struct SliderCrank {
    a: f64,
    l: f64,
    i: f64,
    m: f64,
    n: f64,
}

#[test]
fn reactions_on_coordinates_are_their_generalized_forces() {
    let model = SliderCrank {
        a: 0.3,
        l: 1.1,
        i: 0.2,
        m: 1.5,
        n: 2.0,
    };
    let crank = 0.8_f64;
    let rod = -(0.3 * crank.sin() / 1.1).asin();
    let slider = 0.3 * crank.cos() + 1.1 * rod.cos();
    let guess = State::new(0.0, [crank, rod, slider], [4.0, 0.0, 0.0]);
    let held = [SliderCrank::CRANK];
    let found = model.assemble(guess).hold(held).hold_velocities(held);
    let state = found.solve().expect("it is closed").state;
    let seen = model.outputs(&state);
    let forces = model.constraint_jacobian(&state).transpose() * model.multipliers(&state);
    let found = [seen.on_the_crank, seen.about_the_pin, seen.on_the_slider];
    assert_close("Gᵀ λ", &found, forces.as_slice(), 1e-14);
    assert_close(
        "λ",
        seen.on_the_rod.as_slice(),
        seen.whole.as_slice(),
        1e-15,
    );
}
