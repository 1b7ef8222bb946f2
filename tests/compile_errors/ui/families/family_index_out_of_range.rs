use lagrangian::Lagrangian;

#[derive(Lagrangian)]
#[lagrangian(
    coordinates(theta[3]),
    kinetic = 0.5 * m * (0..3).map(|i| dot(theta[i]).powi(2)).sum(),
    potential = m * g * theta[3],
)]
struct Model {
    m: f64,
    g: f64,
    l: f64,
}

fn main() {}
