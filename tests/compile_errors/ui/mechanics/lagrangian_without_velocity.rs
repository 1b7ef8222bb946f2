use lagrangian::Lagrangian;

#[derive(Lagrangian)]
#[lagrangian(
    coordinates(theta),
    lagrangian = 0.5 * m * theta.powi(2),
)]
struct Model {
    m: f64,
    g: f64,
    l: f64,
}

fn main() {}
