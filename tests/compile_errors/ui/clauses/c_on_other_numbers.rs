use lagrangian::prelude::*;

#[derive(Lagrangian)]
#[lagrangian(coordinates(x), kinetic = 0.5 * m * dot(x).powi(2), scalar = f32, c)]
struct Single {
    m: f32,
}

#[derive(Lagrangian)]
#[lagrangian(c, coordinates(x), kinetic = 0.5 * m * dot(x).powi(2), c)]
struct Twice {
    m: f64,
}

#[derive(Lagrangian)]
#[lagrangian(coordinates(x), kinetic = 0.5 * m * dot(x).powi(2), c = "cart.c")]
struct File {
    m: f64,
}

#[derive(Lagrangian)]
#[lagrangian(coordinates(c_source), kinetic = 0.5 * m * dot(c_source).powi(2), c)]
struct Taken {
    m: f64,
}

fn main() {}
