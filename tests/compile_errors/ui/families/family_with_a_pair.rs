use lagrangian::Lagrangian;

#[derive(Lagrangian)]
#[lagrangian(
    coordinates(theta, x),
    kinetic = 0.5 * m * (dot(theta).powi(2) + dot(x).powi(2)),
    potential = k[(0, 1)] * x,
)]
struct Model {
    m: f64,
    k: [[f64; 2]; 2],
}

fn main() {}
