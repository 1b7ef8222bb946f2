use lagrangian::prelude::*;

#[derive(Lagrangian)]
#[lagrangian(
    coordinates(r, phi),
    kinetic = 0.5 * m * (dot(r).powi(2) + (r * dot(phi)).powi(2)),
    routhian(Radial, without()),
)]
struct Free {
    m: f64,
}

#[derive(Lagrangian)]
#[lagrangian(
    coordinates(r, phi),
    kinetic = 0.5 * m * (dot(r).powi(2) + (r * dot(phi)).powi(2)),
    routhian(Reduced, half_angles, without),
)]
struct Particle {
    m: f64,
}

fn main() {}
