use lagrangian::prelude::*;

#[derive(Lagrangian)]
#[lagrangian(
    coordinates(x),
    scalar = T,
    kinetic = 0.5 * m * dot(x).powi(2),
)]
struct Model<T> {
    m: f64,
    #[lagrangian(skip)]
    label: T,
}

fn main() {}
