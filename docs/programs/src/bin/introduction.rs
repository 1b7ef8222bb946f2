//! A mass that swings on a spring.

use lagrangian::prelude::*;

/// A mass on a spring, in polar coordinates about the point from which it hangs.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(r, theta),
    define(p = r * [sin(theta), -cos(theta)]),
    kinetic = 0.5 * m * dot(p).norm_squared(),
    potential = m * g * p.y + 0.5 * k * (r - rest).powi(2),
)]
struct SwingingSpring {
    m: f64,
    k: f64,
    rest: f64,
    g: f64,
}

fn main() -> Result<(), IntegrationError> {
    let spring = SwingingSpring {
        m: 0.5,
        k: 20.0,
        rest: 1.0,
        g: 9.81,
    };
    let start = State::new(0.0, [1.4, 0.3], [0.0, 0.0]);
    let motion = Problem::new(&spring, start)
        .save(Every(0.5))
        .solve(3.0, Dop853::new())?;
    println!("t [s]   r [m]    θ [rad]");
    for x in motion.samples() {
        let [r, theta] = [SwingingSpring::R, SwingingSpring::THETA].map(|i| x.q[i]);
        println!("{:3.1}   {r:7.4}   {theta:7.4}", x.t);
    }
    let drift = spring.energy(&motion) / spring.energy(&start) - 1.0;
    assert!(drift.abs() < 1e-9);
    println!("The energy is kept to better than 1e-9.");
    Ok(())
}
