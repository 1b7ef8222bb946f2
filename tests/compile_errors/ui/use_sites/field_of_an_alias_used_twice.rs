use lagrangian::Lagrangian;
use lagrangian::nalgebra::Matrix3;

type Inertia = Matrix3<f64>;

#[derive(Lagrangian)]
#[lagrangian(
    coordinates(theta, x),
    kinetic = 0.5 * m * (dot(theta).powi(2) + dot(x).powi(2)),
    potential = l.trace() + l[(0, 1)],
)]
struct Model {
    m: f64,
    l: Inertia,
}

fn main() {}
