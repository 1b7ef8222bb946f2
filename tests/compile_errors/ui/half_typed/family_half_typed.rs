use lagrangian::Lagrangian;

#[derive(Lagrangian)]
#[lagrangian(
    coordinates(theta[]),
    kinetic = 0.5 * m * dot(theta[0]).powi(2),
)]
struct Model {
    m: f64,
    g: f64,
    l: f64,
}

fn main() {}
