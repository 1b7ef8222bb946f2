//! A robot arm: the torques that its motors need along a move.

// ANCHOR: model
use std::f64::consts::FRAC_PI_2;

use lagrangian::nalgebra::Rotation3;
use lagrangian::prelude::*;
use lagrangian::rigid_body::Solid;
use lagrangian_guide::{Curve, Figure};

/// An arm of two links in a vertical plane, each turned by a geared motor.
#[derive(Lagrangian)]
#[lagrangian(
    // The angle of the upper arm from the horizontal, and of the forearm from the upper arm.
    coordinates(shoulder, elbow),
    define(
        // Rotations from the axes of the links to the axes of space: x along it, z up.
        upper_axes = rotation_y(-shoulder),
        lower_axes = upper_axes * rotation_y(-elbow),
        joint = upper_axes * [length, 0.0, 0.0],
    ),
    body(upper = (upper_axes, [0.0, 0.0, 0.0]), lower = (lower_axes, joint)),
    gravity = [0.0, 0.0, -g],
    // The rotors turn `ratio` times as fast as the joints.
    kinetic = 0.5 * rotor * ratio.powi(2) * (dot(shoulder).powi(2) + dot(elbow).powi(2)),
    dissipation = 0.5 * friction * (dot(shoulder).powi(2) + dot(elbow).powi(2)),
    force(shoulder = torque[0], elbow = torque[1]),
    output(hand = joint + lower_axes * [length, 0.0, 0.0]),
)]
struct Arm {
    /// The links, in axes whose origins are their joints.
    upper: RigidBody,
    lower: RigidBody,
    /// The length of each link in m.
    length: f64,
    g: f64,
    /// The moment of inertia of a rotor in kg m², and the ratio of its gear.
    rotor: f64,
    ratio: f64,
    /// The viscous friction of a joint in N m s/rad.
    friction: f64,
    /// The torques of the motors at the joints in N m.
    #[lagrangian(input)]
    torque: Vector2<f64>,
}
// ANCHOR_END: model

// ANCHOR: program
/// A joint's angle, velocity and acceleration on its way from `a` to `b` within a second: the
/// path with the least jerk.
fn move_joint(t: f64, [a, b]: [f64; 2]) -> [f64; 3] {
    let s = [
        t.powi(3) * (10.0 - 15.0 * t + 6.0 * t * t),
        30.0 * (t * (1.0 - t)).powi(2),
        60.0 * t * (1.0 - t) * (1.0 - 2.0 * t),
    ];
    [a + (b - a) * s[0], (b - a) * s[1], (b - a) * s[2]]
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    // An aluminium tube along the link, and a load in the hand.
    let tube = Solid::tube(0.025, 0.03, 0.4)?.with_density(2700.0)?;
    let along_x = Rotation3::from_axis_angle(&Vector3::y_axis(), FRAC_PI_2);
    let link = tube.turned(&along_x).moved(Vector3::new(0.2, 0.0, 0.0));
    let load = RigidBody::particle(1.5, Vector3::new(0.4, 0.0, 0.0))?;
    let arm = Arm {
        upper: link,
        lower: link.plus(&load),
        length: 0.4,
        g: 9.81,
        rotor: 2e-5,
        ratio: 80.0,
        friction: 0.4,
        torque: Vector2::zeros(),
    };

    let level = State::new(0.0, [0.0, 0.0], [0.0, 0.0]);
    let hold = arm.inverse_dynamics(&level, &Vector2::zeros());
    println!("To hold it level: {:.2} and {:.2} N m", hold[0], hold[1]);
    let mass = arm.mass_matrix(&level);
    println!(
        "Inertias there: {:.4}, {:.4}, {:.4} kg m²",
        mass[(0, 0)],
        mass[(0, 1)],
        mass[(1, 1)]
    );

    let mut torques = [Vec::new(), Vec::new()];
    for t in (0..=100).map(|i| 0.01 * f64::from(i)) {
        let joints = [move_joint(t, [-1.57, 0.5]), move_joint(t, [0.0, 1.2])];
        let [q, v, a] = [0, 1, 2].map(|order| joints.map(|joint| joint[order]));
        let torque = arm.inverse_dynamics(&State::new(t, q, v), &a.into());
        torques[0].push([t, torque[0]]);
        torques[1].push([t, torque[1]]);
    }
    for (name, torques) in ["shoulder", "elbow"].iter().zip(&torques) {
        let most = torques.iter().fold(0.0_f64, |most, x| most.max(x[1].abs()));
        println!("Largest torque of the {name}: {most:.2} N m");
    }
    let end = State::new(1.0, [0.5, 1.2], [0.0, 0.0]);
    let hand = arm.outputs(&end).hand;
    println!("The hand ends at x = {:.3} m, z = {:.3} m.", hand.x, hand.z);

    let [shoulder, elbow] = torques;
    Figure::new("declare", "t in s", "torque in N m")
        .draw(&[Curve::new("shoulder", shoulder), Curve::new("elbow", elbow)])
}
// ANCHOR_END: program
