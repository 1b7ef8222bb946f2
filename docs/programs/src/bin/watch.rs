//! A runner on a springy leg: events that change the model, and a gait that settles by itself.

// ANCHOR: model
use lagrangian::prelude::*;
use lagrangian_guide::{Curve, Figure};

/// A body that bounces on a leg without mass (R. Blickhan, The spring-mass model for running and
/// hopping, 1989). The leg touches down at a fixed angle, and leaves the ground when it is as long
/// as at rest.
#[derive(Lagrangian)]
#[lagrangian(
    taylor,
    coordinates(x, y),
    define(leg = [x - foot, y].norm()),
    kinetic = 0.5 * m * (dot(x).powi(2) + dot(y).powi(2)),
    potential = m * g * y + 0.5 * stance * k * (leg - rest).powi(2),
    event(
        touchdown = y - rest * sin(angle),
        takeoff = leg - rest,
        apex = dot(y),
    ),
)]
struct Runner {
    m: f64,
    k: f64,
    rest: f64,
    g: f64,
    /// The angle of the leg from the ground at touchdown.
    angle: f64,
    /// The place of the foot, and 1 while it is on the ground, else 0.
    foot: f64,
    stance: f64,
}
// ANCHOR_END: model

// ANCHOR: program
/// A run of 12 m at most, from an apex at 5 m/s.
fn run(degrees: f64) -> Result<Vec<[f64; 2]>, IntegrationError> {
    let angle = degrees.to_radians();
    let runner = Runner {
        m: 80.0,
        k: 20e3,
        rest: 1.0,
        g: 9.81,
        angle,
        foot: 0.0,
        stance: 0.0,
    };
    let start = State::new(0.0, [0.0, 1.0], [5.0, 0.0]);
    let motion = Problem::new(runner, start)
        .on(Runner::TOUCHDOWN)
        .falling()
        .then_with(|x, equations| {
            let place = x.q[Runner::X];
            equations.change(|runner| {
                runner.foot = place + runner.rest * angle.cos();
                runner.stance = 1.0;
            });
        })
        .on(Runner::TAKEOFF)
        .rising()
        .then_with(|_, equations| equations.change(|runner| runner.stance = 0.0))
        .on(Runner::APEX)
        .falling()
        .record()
        .when(|x| [x.q[Runner::Y] - 0.5, 12.0 - x.q[Runner::X]])
        .falling()
        .stop()
        .save(Every(0.01))
        .solve(60.0, Taylor::new())?;

    println!(
        "{degrees}°: ends at x = {:.2} m, t = {:.3} s",
        motion.q[0], motion.t
    );
    let apices = motion
        .events()
        .iter()
        .filter(|event| event.is(Runner::APEX));
    for apex in apices {
        let (t, height, speed) = (apex.t, apex.q[Runner::Y], apex.v[Runner::X]);
        println!("   apex after {t:.3} s: {height:.4} m at {speed:.4} m/s");
    }
    Ok(motion.samples().iter().map(|x| x.q.into()).collect())
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    Figure::new("watch", "x in m", "height of the body in m").draw(&[
        Curve::new("leg at 68°", run(68.0)?),
        Curve::new("leg at 72°", run(72.0)?),
    ])
}
// ANCHOR_END: program
