//! A robot that balances on two wheels: a regulator in continuous time, and as its processor runs it.

// ANCHOR: model
use lagrangian::analysis::StateSpace;
use lagrangian::nalgebra::{Matrix1, RowSVector};
use lagrangian::prelude::*;
use lagrangian_guide::{Curve, Figure};

/// A body on two wheels, on ground that may slope upwards. Its motors turn the wheels against it.
#[derive(Lagrangian)]
#[lagrangian(
    taylor,
    // The way along the ground, and the tilt of the body forwards.
    coordinates(x, tilt),
    define(
        top = [x + height * sin(tilt), height * cos(tilt)],
        turn = x / radius - tilt,
        up = [sin(slope), cos(slope)],
    ),
    kinetic = 0.5 * (wheels + wheel_inertia / radius.powi(2)) * dot(x).powi(2),
    kinetic = 0.5 * body * dot(top).norm_squared() + 0.5 * body_inertia * dot(tilt).powi(2),
    potential = g * (wheels * [x, 0.0] + body * top).dot(up),
    // On an angle that is a function of the coordinates: on the wheels, and against the body.
    force(turn = torque),
)]
struct Robot {
    wheels: f64,
    wheel_inertia: f64,
    radius: f64,
    body: f64,
    body_inertia: f64,
    height: f64,
    g: f64,
    slope: f64,
    /// Of both motors in N m.
    #[lagrangian(input)]
    torque: f64,
}
// ANCHOR_END: model

// ANCHOR: design
/// The period of the controller, and the time constant of the motors, in s.
const PERIOD: f64 = 1e-3;
const LAG: f64 = 5e-3;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let robot = Robot {
        wheels: 0.4,
        wheel_inertia: 3e-4,
        radius: 0.04,
        body: 1.2,
        body_inertia: 8e-3,
        height: 0.12,
        g: 9.81,
        slope: 0.0,
        torque: 0.0,
    };
    let upright = State::new(0.0, [0.0, 0.0], [0.0, 0.0]);
    let plant = StateSpace::<f64, 4, 1, 4>::of(&robot, &upright);
    let poles = plant.poles().ok_or("no eigenvalues")?;
    println!("It falls at a rate of {:.2}/s.", poles.abscissa());

    // What counts as much as 0.1 N m: 0.1 m, 0.1 rad, 0.5 m/s, 1 rad/s.
    let weights = SVector::from([100.0, 100.0, 4.0, 1.0]);
    let effort = Matrix1::new(100.0);
    let regulator = plant.regulator(&SMatrix::from_diagonal(&weights), &effort)?;
    println!("Gain for (x, tilt, ẋ, tilt˙): {}", digits(regulator.gain));

    // ANCHOR_END: design

    // ANCHOR: sampled
    // As the processor runs it: sampled, and with the integral of x as a fifth state.
    let mut a = plant.a.fixed_resize::<5, 5>(0.0);
    a[(4, Robot::X)] = 1.0;
    let sampled = StateSpace::new(a, plant.b.push(0.0)).discretized(PERIOD);
    let weights = SMatrix::from_diagonal(&weights.push(100.0));
    let gain = sampled.regulator(&weights, &effort)?.gain;
    println!("Sampled, and the integral:    {}", digits(gain));

    // ANCHOR_END: sampled

    // ANCHOR: loop
    // It starts tilted, on a slope of 3° of which neither knows.
    let slope = 3_f64.to_radians();
    let real = Robot { slope, ..robot };
    let start = State::new(0.0, [0.0, 0.1], [0.0, 0.0]);
    let continuous = Problem::new(&real, start)
        .feedback(|s| regulator.input(s))
        .save(Every(0.01))
        .solve(8.0, Dop853::new())?;
    let sampled = Problem::new(&real, start)
        .sampled_feedback(PERIOD, [0.0], |s, integral| {
            integral[0] += PERIOD * s.q[Robot::X];
            let x = SVector::from([s.q[0], s.q[1], s.v[0], s.v[1], integral[0]]);
            (-gain * x)[0].clamp(-0.6, 0.6)
        })
        .lagged([LAG])
        .save(Every(0.01))
        .solve(8.0, Taylor::order_12())?;
    let [one, other] = [continuous.last.q, sampled.last.q].map(|q| (q[0], q[1].to_degrees()));
    println!(
        "Continuous: after 8 s x = {:.4} m, tilt {:.3}°",
        one.0, one.1
    );
    println!(
        "Sampled:    after 8 s x = {:.4} m, tilt {:.3}°",
        other.0, other.1
    );
    let commanded = sampled.last.z.0.inputs[0];
    println!(
        "It holds by {:.4} N m; the motors give {:.4} N m.",
        commanded, sampled.last.z.1[0]
    );

    Figure::new("control", "t in s", "x in m").draw(&[
        Curve::new(
            "continuous, without integral",
            continuous.samples().iter().map(|s| [s.t, s.q[0]]).collect(),
        ),
        Curve::new(
            "1 kHz, integral, lag of 5 ms",
            sampled.samples().iter().map(|s| [s.t, s.q[0]]).collect(),
        ),
    ])
}

/// Three digits of each number of a row.
fn digits<const N: usize>(row: RowSVector<f64, N>) -> String {
    let digits: Vec<_> = row.iter().map(|x| format!("{x:.3}")).collect();
    digits.join(", ")
}
// ANCHOR_END: loop
