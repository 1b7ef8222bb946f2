use lagrangian::Lagrangian;

#[derive(Lagrangian)]
#[lagrangian(
    coordinates(theta),
    kinetic = 0.5 * m * theta.dot().powi(2),
)]
struct Model {
    m: f64,
}

fn main() {}
