//! A pendulum that bounces off a wall: an event of the declaration, a reaction to it, and where the motion ends.
//!
//! `cargo run --release --example bouncing_pendulum`

use lagrangian::prelude::*;

/// A pendulum beside a vertical wall, which it meets at its lowest point.
#[derive(Lagrangian)]
#[lagrangian(
    taylor,
    coordinates(theta),
    define(bob = l * [sin(theta), -cos(theta)]),
    kinetic = 0.5 * m * dot(bob).norm_squared(),
    potential = m * g * bob.y,
    event(wall = bob.x, turning = dot(theta)),
)]
struct Pendulum {
    m: f64,
    l: f64,
    g: f64,
}

/// The part of its velocity that the bob keeps in an impact.
const RESTITUTION: f64 = 0.8;

fn main() -> Result<(), IntegrationError> {
    let pendulum = Pendulum {
        m: 0.5,
        l: 1.0,
        g: 9.81,
    };
    let start = State::new(0.0, [1.2], [0.0]);
    let motion = Problem::new(&pendulum, start)
        .on([Pendulum::WALL, Pendulum::TURNING])
        .falling()
        .then(|x| {
            // The angle is zero at the wall, the velocity at a turning point.
            if x.q[Pendulum::THETA].abs() < x.v[Pendulum::THETA].abs() {
                x.v[Pendulum::THETA] *= -RESTITUTION;
            }
        })
        .solve(1000.0, Taylor::new())?;

    let events = motion.events().iter();
    let (impacts, turns): (Vec<&Occurrence<_>>, Vec<_>) = events.partition(|x| x.event == 0);
    println!("  impact at [s]  speed [m/s]  then rises to [rad]");
    for (impact, turn) in impacts.iter().zip(&turns).take(10) {
        let (speed, angle) = (impact.x.v[Pendulum::THETA].abs(), turn.x.q[Pendulum::THETA]);
        println!("{:15.6} {:12.6} {angle:20.6}", impact.t, speed * pendulum.l);
    }
    let small = core::f64::consts::PI * (pendulum.l / pendulum.g).sqrt();
    println!("…");
    println!(
        "{} impacts until t = {} s, {small:.4} s apart in the end: small swings take half a period each",
        impacts.len(),
        motion.t
    );
    // Each impact keeps the square of the restitution of the energy above the lowest point.
    let lowest = State::new(0.0, [0.0], [0.0]);
    let above = |state: &State<f64, 1>| pendulum.energy(state) - pendulum.energy(&lowest);
    for (n, turn) in (1..).zip(&turns).take(10) {
        let expected = above(&start) * RESTITUTION.powi(2 * n);
        let found = above(&At::from((turn.t, turn.x)));
        assert!(
            (found - expected).abs() <= 1e-13 * above(&start),
            "{found} {expected}"
        );
    }
    Ok(())
}
