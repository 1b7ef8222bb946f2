//! A tumbling satellite that three reaction wheels bring to rest: what momentum the body had is in the wheels
//! then, and the whole has kept it.
//!
//! `cargo run --release --example satellite`

use lagrangian::nalgebra::{Matrix3, Vector3};
use lagrangian::prelude::*;

/// Yaw, pitch and roll of the body, and the angles of its wheels, one about each of its axes.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(yaw, pitch, roll, chi[3]),
    define(
        attitude = rotation_zyx(yaw, pitch, roll),
        w = angular_velocity(attitude),
        spin = (0..3).map(|i| dot(chi[i])).collect(),
    ),
    kinetic = 0.5 * w.dot(body * w) + 0.5 * wheel * (w + spin).norm_squared(),
    force(chi[i] = torque[i] for i in 0..3),
    output(w = w, spin = spin, momentum = attitude * (body * w + wheel * (w + spin))),
)]
struct Satellite {
    /// Tensor of inertia in kg m², in which the wheels count as if they had no inertia about their axes.
    body: Matrix3<f64>,
    /// Moment of inertia of a wheel about its axis in kg m².
    wheel: f64,
    /// Torques of the motors of the wheels in N m, which the controller sets.
    #[lagrangian(input)]
    torque: Vector3<f64>,
}

fn main() -> Result<(), IntegrationError> {
    let satellite = Satellite {
        body: Matrix3::new(10.0, -0.4, 0.3, -0.4, 14.0, 0.2, 0.3, 0.2, 12.0),
        wheel: 0.05,
        torque: Vector3::zeros(),
    };

    // What a motor exerts on its wheel it exerts on the body in the opposite direction.
    let law = |state: &State<f64, 6>| {
        let angles =
            [Satellite::ROLL, Satellite::PITCH, Satellite::YAW].map(|angle| state.q[angle]);
        2.0 * Vector3::from(angles) + 7.0 * satellite.outputs(state).w
    };

    let start = State::new(
        0.0,
        [0.9, -0.5, 1.2, 0.0, 0.0, 0.0],
        [0.04, 0.06, -0.03, 0.0, 0.0, 0.0],
    );
    let method = Dop853::new()
        .relative_tolerance(1e-12)
        .absolute_tolerance(1e-12);
    let motion = Problem::new(&satellite, start)
        .feedback(law)
        .save(Every(4.0))
        .solve(40.0, method)?;

    let momentum = satellite.outputs(&start).momentum;
    println!(
        "  t [s]    yaw   pitch   roll [degrees]    wheels [rad/s]       change of momentum [N m s]"
    );
    for state in motion {
        let outputs = satellite.outputs(&state);
        let [yaw, pitch, roll] = [Satellite::YAW, Satellite::PITCH, Satellite::ROLL]
            .map(|angle| state.q[angle].to_degrees());
        let [first, second, third] = outputs.spin.into();
        println!(
            "{:7.1} {yaw:7.2} {pitch:7.2} {roll:7.2} {first:13.2} {second:7.2} {third:7.2} {:20.1e}",
            state.t,
            (outputs.momentum - momentum).norm()
        );
    }
    Ok(())
}
