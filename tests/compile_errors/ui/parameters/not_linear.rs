use lagrangian::prelude::*;

#[derive(Lagrangian)]
#[lagrangian(
    coordinates(theta),
    kinetic = 0.5 * m * (l * dot(theta)).powi(2),
    potential = -m * g * l * cos(theta + offset) + 0.5 * k * ((l.powi(2) + a[1].powi(2)).sqrt() - theta).powi(2),
    regressor(m, l, offset, a, k),
)]
struct WithinFunctions {
    m: f64,
    l: f64,
    g: f64,
    offset: f64,
    a: [f64; 2],
    k: f64,
}

#[derive(Lagrangian)]
#[lagrangian(
    coordinates(x),
    kinetic = 0.5 * m * dot(x).powi(2),
    potential = level + offset * t,
    regressor(level, offset),
)]
struct WithoutEffect {
    m: f64,
    level: f64,
    offset: f64,
}

#[derive(Lagrangian)]
#[lagrangian(coordinates(x), kinetic = 0.5 * exp(a) * dot(x).powi(2), regressor)]
struct NothingLinear {
    a: f64,
}

fn main() {}
