//! What the page of a struct shows: its equations.

use lagrangian::prelude::*;

/// A bead on a hoop that turns about its vertical diameter.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(theta),
    define(p = r * [sin(theta), -cos(theta)]),
    kinetic = 0.5 * m * (dot(p).norm_squared() + (omega * p.x).powi(2)),
    potential = m * g * p.y,
    dissipation = 0.5 * c * dot(theta).powi(2),
)]
struct Bead {
    m: f64,
    r: f64,
    g: f64,
    omega: f64,
    c: f64,
}

fn main() {
    println!("{}", Bead::EQUATIONS);
}
