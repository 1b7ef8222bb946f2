//! The double pendulum: declare its energies, read its equations, sample its motion, look at its energy.
//!
//! `cargo run --release --example double_pendulum`

use lagrangian::prelude::*;
use lagrangian_examples::wrapped;

/// Two point masses on massless rods; the angles are measured from the vertical.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(theta1, theta2),
    define(
        x1 = l1 * sin(theta1),
        y1 = -l1 * cos(theta1),
        x2 = x1 + l2 * sin(theta2),
        y2 = y1 - l2 * cos(theta2),
    ),
    // `dot` is the total time derivative: velocities need not be written out.
    kinetic = 0.5 * m1 * (dot(x1).powi(2) + dot(y1).powi(2))
        + 0.5 * m2 * (dot(x2).powi(2) + dot(y2).powi(2)),
    potential = (m1 * y1 + m2 * y2) * g,
)]
struct DoublePendulum {
    m1: f64,
    m2: f64,
    l1: f64,
    l2: f64,
    g: f64,
}

fn main() -> Result<(), IntegrationError> {
    let model = DoublePendulum {
        m1: 1.0,
        m2: 0.5,
        l1: 1.0,
        l2: 0.8,
        g: 9.81,
    };
    println!("{}", wrapped(DoublePendulum::EQUATIONS));

    let start = State::new(0.0, [2.0, 2.5], [0.0, 0.0]);
    let motion = Problem::new(&model, start)
        .save(Every(1.0))
        .solve(10.0, Dop853::new())?;
    // Nothing does work on the pendulum but gravity: what its energy changes by is numerical error.
    println!("  t [s]  θ₁ [rad]  θ₂ [rad]  energy error [J]");
    for state in motion {
        let error = model.energy(&state) - model.energy(&start);
        println!(
            "{:7.1} {:9.4} {:9.4}  {error:16.1e}",
            state.t,
            state.q[DoublePendulum::THETA1],
            state.q[DoublePendulum::THETA2]
        );
    }
    Ok(())
}
