//! Furuta's pendulum, declared, simulated and regulated.

use lagrangian::analysis::StateSpace;
use lagrangian::nalgebra::{Matrix1, Matrix4, RowVector4, Vector4};
use lagrangian::prelude::*;

/// A motor turns an arm by α about the vertical; at its end a rod with a mass at
/// its tip swings by θ about the arm.
#[derive(Lagrangian, Clone, Debug)]
#[lagrangian(
    taylor,
    coordinates(alpha, theta),
    define(tip = [
        r * cos(alpha) - l * sin(theta) * sin(alpha),
        r * sin(alpha) + l * sin(theta) * cos(alpha),
        -l * cos(theta),
    ]),
    kinetic = 0.5 * j * dot(alpha).powi(2) + 0.5 * m * dot(tip).norm_squared(),
    potential = m * g * tip.z,
    dissipation = 0.5 * (d_alpha * dot(alpha).powi(2) + d_theta * dot(theta).powi(2)),
    force(alpha = torque),
    event(switch = alpha - 1.0),
)]
pub struct Furuta {
    /// The inertia of the arm about the axis of the motor in kg m².
    pub j: f64,
    /// The mass at the tip in kg.
    pub m: f64,
    /// The length of the arm in m.
    pub r: f64,
    /// The length of the rod in m.
    pub l: f64,
    /// The acceleration of gravity in m/s².
    pub g: f64,
    /// The friction of the motor in N m s.
    pub d_alpha: f64,
    /// The friction of the rod's joint in N m s.
    pub d_theta: f64,
    /// The torque of the motor in N m.
    #[lagrangian(input)]
    pub torque: f64,
}

/// What all programs compute.
#[derive(Clone, Copy, Debug)]
pub struct Results {
    /// When the arm reaches 1 rad and the motor is switched off, in s.
    pub switch: f64,
    /// The coordinates and velocities after 10 s.
    pub end: Vector4<f64>,
    /// A of ẋ = A x + B u about the upright rod.
    pub a: Matrix4<f64>,
    /// B.
    pub b: Vector4<f64>,
    /// The gain K of the law u = −K x with unit weights.
    pub k: RowVector4<f64>,
}

/// Simulates, linearizes and regulates.
///
/// # Errors
///
/// Those of the integration and of the regulator.
pub fn results() -> Result<Results, Box<dyn std::error::Error>> {
    let furuta = Furuta {
        j: 3e-3,
        m: 0.2,
        r: 0.25,
        l: 0.3,
        g: 9.81,
        d_alpha: 2e-3,
        d_theta: 5e-4,
        torque: 0.05,
    };

    // The motor turns the arm up to 1 rad, then it is switched off.
    let motion = Problem::new(furuta.clone(), State::new(0.0, [0.0; 2], [0.0; 2]))
        .on(Furuta::SWITCH)
        .rising()
        .then_with(|_, furuta| furuta.change(|furuta| furuta.torque = 0.0))
        .solve(10.0, Taylor::new())?;

    // Linear model about the upright rod, and the regulator with unit weights.
    let upright = State::new(0.0, [0.0, core::f64::consts::PI], [0.0; 2]);
    let plant = StateSpace::of(&furuta.with_inputs([0.0]), &upright);
    let regulator = plant.regulator(&Matrix4::identity(), &Matrix1::identity())?;

    Ok(Results {
        switch: motion.events()[0].t,
        end: Vector4::new(motion.q[0], motion.q[1], motion.v[0], motion.v[1]),
        a: plant.a,
        b: plant.b,
        k: regulator.gain,
    })
}
