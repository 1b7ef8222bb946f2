use lagrangian::prelude::*;

#[derive(Lagrangian)]
#[lagrangian(taylor = 20, coordinates(x), kinetic = 0.5 * m * dot(x).powi(2))]
struct Order {
    m: f64,
}

#[derive(Lagrangian)]
#[lagrangian(taylor, coordinates(x), kinetic = 0.5 * m * dot(x).powi(2), taylor)]
struct Twice {
    m: f64,
}

fn main() {}
