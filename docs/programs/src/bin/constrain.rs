//! A slider-crank at a constant speed: what its bearings and the wall of its cylinder carry.

// ANCHOR: model
use std::f64::consts::{PI, TAU};

use lagrangian::prelude::*;
use lagrangian_guide::{Curve, Figure};

/// A crank, a connecting rod and a piston that moves along x. The piston is free, and three
/// constraints put the parts together.
#[derive(Lagrangian)]
#[lagrangian(
    taylor,
    coordinates(crank, rod, piston: Vector2),
    define(
        pin = r * [cos(crank), sin(crank)],
        // The rod from its end at the piston to the pin, and its centre of gravity.
        along = l * [-cos(rod), sin(rod)],
        center = pin - c / l * along,
    ),
    kinetic = 0.5 * m_rod * dot(center).norm_squared() + 0.5 * i_rod * dot(rod).powi(2),
    kinetic = 0.5 * m_piston * dot(piston).norm_squared(),
    // λ is the force on the piston, the body of the first term.
    constraint(bearing = piston + along - pin),
    constraint(wall = piston.y),
    // It contains the time. λ is the torque of the motor.
    constraint(motor = crank - speed * t),
    output(
        force = reaction(bearing),
        side = reaction(wall),
        torque = reaction(motor),
    ),
)]
struct SliderCrank {
    /// The radius of the crank, the length of the rod, and the distance of its centre of gravity
    /// from the pin, in m.
    r: f64,
    l: f64,
    c: f64,
    /// Masses in kg, and the moment of inertia of the rod about its centre of gravity in kg m².
    m_rod: f64,
    i_rod: f64,
    m_piston: f64,
    /// The angular velocity of the crank in rad/s.
    speed: f64,
}
// ANCHOR_END: model

// ANCHOR: start
fn main() -> Result<(), Box<dyn std::error::Error>> {
    let machine = SliderCrank {
        r: 0.04,
        l: 0.14,
        c: 0.045,
        m_rod: 0.6,
        i_rod: 1.6e-3,
        m_piston: 0.45,
        speed: 3000.0 * TAU / 60.0,
    };
    // The crank is given; all others are guesses.
    let guess = State::new(0.0, [0.0, 0.3, 0.1, 0.0], [machine.speed, 0.0, 0.0, 0.0]);
    let start = machine
        .assemble(guess)
        .hold([SliderCrank::CRANK])
        .hold_velocities([SliderCrank::CRANK])
        .solve()?
        .state;
    let free = machine.degrees_of_freedom(&start);
    println!("Degrees of freedom: {}", free.velocities);
    println!("The piston starts at x = {:.4} m.", start.q[2]);

    // ANCHOR_END: start

    // ANCHOR: motion
    let turn = TAU / machine.speed;
    let motion = Problem::new(&machine, start)
        .save(Every(turn / 720.0))
        .solve(2.0 * turn, Taylor::new())?;
    let outputs: Vec<_> = motion
        .samples()
        .iter()
        .map(|x| machine.outputs(x))
        .collect();
    let largest = |force: fn(&SliderCrankOutputs<f64>) -> f64| {
        outputs
            .iter()
            .map(force)
            .fold(0.0_f64, |most, x| most.max(x.abs()))
    };
    println!(
        "Largest force of the bearing at the piston: {:.0} N",
        largest(|x| x.force.norm())
    );
    println!("Largest force of the wall: {:.0} N", largest(|x| x.side));
    println!(
        "Largest torque of the motor: {:.1} N m",
        largest(|x| x.torque)
    );

    // ANCHOR_END: motion

    // ANCHOR: checks
    // What checks it: the closed form, the constraints, and a motor that does no work in a turn.
    for x in motion.samples() {
        let (sin, cos) = x.q[SliderCrank::CRANK].sin_cos();
        let place = machine.r * cos + (machine.l.powi(2) - (machine.r * sin).powi(2)).sqrt();
        assert!((x.q[2] - place).abs() < 1e-14);
        let (gaps, speeds) = machine.constraint_residuals(x);
        assert!(gaps.amax() < 1e-14 && speeds.amax() < 1e-12);
    }
    let mean = outputs[..720].iter().map(|x| x.torque).sum::<f64>() / 720.0;
    assert!(mean.abs() < 1e-10);
    println!("The piston agrees with its closed form; the mean torque is below 1e-10 N m.");

    // ANCHOR_END: checks

    // ANCHOR: figure
    let curve = |name, force: fn(&SliderCrankOutputs<f64>) -> f64| {
        let points = outputs.iter().zip(motion.samples());
        let points = points.map(|(y, x)| [x.q[0] * 180.0 / PI, 1e-3 * force(y)]);
        Curve::new(name, points.collect())
    };
    Figure::new("constrain", "angle of the crank in degrees", "force in kN").draw(&[
        curve("bearing, along x", |x| x.force.x),
        curve("wall", |x| x.side),
    ])
}
// ANCHOR_END: figure
