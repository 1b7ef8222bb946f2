use lagrangian::prelude::*;

#[derive(Lagrangian)]
#[lagrangian(
    coordinates(r, phi),
    kinetic = 0.5 * m * (dot(r).powi(2) + (r * dot(phi)).powi(2)),
    potential = -m * mu / r,
    output(position = r * [cos(phi), sin(phi)]),
    routhian(RadialMotion, without(positions)),
)]
struct Orbit {
    m: f64,
    mu: f64,
}

#[derive(Lagrangian)]
#[lagrangian(
    coordinates(r, phi),
    kinetic = 0.5 * m * (dot(r).powi(2) + (r * dot(phi)).powi(2)),
    potential = -m * mu / r,
    routhian(Radial, without(kinetic)),
)]
struct Kepler {
    m: f64,
    mu: f64,
}

fn main() {}
