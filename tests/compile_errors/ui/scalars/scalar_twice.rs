use lagrangian::prelude::*;

#[derive(Lagrangian)]
#[lagrangian(
    coordinates(x),
    scalar = f64,
    scalar = f32,
    kinetic = 0.5 * m * dot(x).powi(2),
)]
struct Model {
    m: f64,
}

fn main() {}
