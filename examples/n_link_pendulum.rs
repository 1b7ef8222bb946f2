//! A chain of twenty pendulums, declared as one family: it falls from an arc, and keeps its energy.
//!
//! `cargo run --release --example n_link_pendulum`

use std::f64::consts::FRAC_PI_2;

use lagrangian::prelude::*;

/// Point masses on massless rods, each of which hangs on the one before; angles from the vertical.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(theta[20]),
    define(p[i] = (0..=i).map(|k| l[k] * [sin(theta[k]), -cos(theta[k])]).sum() for i in 0..20),
    kinetic = (0..20).map(|i| 0.5 * m[i] * dot(p[i]).norm_squared()).sum(),
    potential = (0..20).map(|i| m[i] * g * p[i].y).sum(),
)]
struct Chain {
    m: [f64; 20],
    l: [f64; 20],
    g: f64,
}

fn main() -> Result<(), IntegrationError> {
    // One metre and one kilogram altogether.
    let chain = Chain {
        m: [0.05; 20],
        l: [0.05; 20],
        g: 9.81,
    };
    let links = Chain::THETA;
    let cost = Chain::OPERATIONS.accelerations.total();
    println!(
        "{} links, whose accelerations take {cost} operations",
        links.len()
    );

    // It is let go from an arc, from the vertical to the horizontal.
    let arc = SVector::from_iterator((0..20).map(|i| FRAC_PI_2 * f64::from(i) / 19.0));
    let start = State::new(0.0, arc, SVector::zeros());
    let method = Dop853::new()
        .relative_tolerance(1e-10)
        .absolute_tolerance(1e-10);
    let motion = Problem::new(&chain, start)
        .save(Every(0.1))
        .solve(1.0, method)?;

    println!("  t [s]  end x [m]  end y [m]  energy error [J]");
    for state in motion {
        let (x, y) = links
            .iter()
            .zip(chain.l)
            .fold((0.0, 0.0), |(x, y), (&link, l)| {
                (x + l * state.q[link].sin(), y - l * state.q[link].cos())
            });
        let error = chain.energy(&state) - chain.energy(&start);
        println!("{:7.1} {x:10.4} {y:10.4}  {error:16.1e}", state.t);
    }
    Ok(())
}
