use lagrangian::Lagrangian;

#[derive(Lagrangian)]
#[lagrangian(
    coordinates(theta, x),
    kinetic = 0.5 * m * (dot(theta).powi(2) + dot(x).powi(2)),
    potential = (0..2).map(|i| { let h = i * x; h }).sum(),
)]
struct Model {
    m: f64,
    g: f64,
    l: f64,
}

fn main() {}
