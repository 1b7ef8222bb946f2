use lagrangian::Lagrangian;
use lagrangian::nalgebra::Matrix3;

#[derive(Lagrangian)]
#[lagrangian(
    coordinates(theta, x),
    kinetic = 0.5 * m * (dot(theta).powi(2) + dot(x).powi(2)),
    potential = l[(0, 1)],
)]
struct Model {
    m: f64,
    #[lagrangian(type = Matrix3<f64>)]
    l: [f64; 3],
}

fn main() {}
