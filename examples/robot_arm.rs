//! An arm of three joints that follows a path by computed torques: the torques that give the accelerations
//! wanted are those of the inverse dynamics.
//!
//! `cargo run --release --example robot_arm`

use lagrangian::nalgebra::Vector3;
use lagrangian::prelude::*;

/// Yaw, shoulder and elbow; two slender links along the unit vectors `upper` and `lower`.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(q[3]),
    define(
        turn = rotation_z(q[0]),
        upper = turn * [cos(q[1]), 0.0, sin(q[1])],
        lower = turn * [cos(q[1] + q[2]), 0.0, sin(q[1] + q[2])],
        elbow = length * upper,
        tip = elbow + length * lower,
    ),
    // A slender link: 1/2 m v² of its centre, and 1/2 (m l²/12) u̇² for its direction u.
    kinetic = 0.5 * column * dot(q[0]).powi(2),
    kinetic = 0.5 * m * (dot(elbow / 2).norm_squared() + dot(elbow).norm_squared() / 12),
    kinetic = 0.5 * m * (dot((elbow + tip) / 2).norm_squared() + dot(tip - elbow).norm_squared() / 12),
    kinetic = 0.5 * load * dot(tip).norm_squared(),
    potential = g * (m * elbow.z / 2 + m * (elbow + tip).z / 2 + load * tip.z),
    force(q[i] = torque[i] for i in 0..3),
    output(tip = tip, power = torque.dot((0..3).map(|i| dot(q[i])).collect())),
)]
struct RobotArm {
    /// Moment of inertia of the column in kg m².
    column: f64,
    /// Mass of each link in kg.
    m: f64,
    /// Mass at the tip in kg.
    load: f64,
    /// Length of each link in m.
    length: f64,
    /// Acceleration of gravity in m/s².
    g: f64,
    /// Torques of the joints in N m, which the controller sets.
    #[lagrangian(input)]
    torque: Vector3<f64>,
}

/// The angles wanted at a time, their velocities and their accelerations.
fn path(t: f64) -> [Vector3<f64>; 3] {
    let (sin, cos) = t.sin_cos();
    [
        Vector3::new(cos, 0.6 + 0.3 * sin, -1.0 + 0.4 * cos),
        Vector3::new(-sin, 0.3 * cos, -0.4 * sin),
        Vector3::new(-cos, -0.3 * sin, -0.4 * cos),
    ]
}

/// The rate at which errors are to vanish, in 1/s.
const RATE: f64 = 4.0;

fn main() -> Result<(), IntegrationError> {
    let arm = RobotArm {
        column: 0.2,
        m: 2.0,
        load: 1.0,
        length: 0.4,
        g: 9.81,
        torque: Vector3::zeros(),
    };
    let free = arm.with_inputs(Vector3::zeros());
    let free = free.dynamics();
    let law = |state: &State<f64, 3>| {
        let [q, v, a] = path(state.t);
        let wanted = a - 2.0 * RATE * (state.v - v) - RATE * RATE * (state.q - q);
        free.inverse_dynamics(state, &wanted)
    };

    // It begins at rest and beside the path.
    let start = State::new(0.0, [0.8, 0.5, -0.4], [0.0; 3]);
    let method = Dop853::new()
        .relative_tolerance(1e-10)
        .absolute_tolerance(1e-10);
    let motion = Problem::new(&arm, start)
        .feedback(law)
        .save(Every(0.4))
        .solve(4.0, method)?;

    // With these torques ë + 2 λ ė + λ² e = 0, so that e = (e₀ + (ė₀ + λ e₀) t) exp(−λ t).
    let [q, v, _] = path(0.0);
    let (error, rate) = (start.q - q, start.v - v);
    println!("  t [s]    tip x      y      z [m]  power [W]  error [rad]  beside its closed form");
    for state in motion {
        let outputs = arm.with_inputs(law(&state)).outputs(&state);
        let [x, y, z] = outputs.tip.into();
        let found = state.q - path(state.t)[0];
        let expected = (error + (rate + RATE * error) * state.t) * (-RATE * state.t).exp();
        println!(
            "{:7.1} {x:9.3} {y:6.3} {z:6.3} {:13.3} {:12.1e} {:23.1e}",
            state.t,
            outputs.power,
            found.norm(),
            (found - expected).norm()
        );
    }
    Ok(())
}
