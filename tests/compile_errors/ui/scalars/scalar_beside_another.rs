use lagrangian::prelude::*;

#[derive(Lagrangian)]
#[lagrangian(
    coordinates(x),
    scalar = f64,
    kinetic = 0.5 * m * dot(x).powi(2),
)]
struct Model<T: Scalar> {
    m: T,
}

fn main() {}
