use lagrangian::Lagrangian;
use lagrangian::nalgebra::Vector3;

#[derive(Lagrangian)]
#[lagrangian(
    coordinates(theta, x),
    kinetic = 0.5 * m * (dot(theta).powi(2) + dot(x).powi(2)),
    potential = ends.norm(),
)]
struct Model {
    m: f64,
    ends: [Vector3<f64>; 2],
}

fn main() {}
