use lagrangian::Lagrangian;
use lagrangian::nalgebra::{Matrix3, Vector2, Vector3};

#[derive(Lagrangian)]
#[lagrangian(
    coordinates(theta, x),
    kinetic = 0.5 * m * (dot(theta).powi(2) + dot(x).powi(2)),
    potential = triple(b, b),
)]
struct Model {
    m: f64,
    a: Vector3<f64>,
    b: Vector2<f64>,
    j: Matrix3<f64>,
    l: [f64; 4],
}

fn main() {}
