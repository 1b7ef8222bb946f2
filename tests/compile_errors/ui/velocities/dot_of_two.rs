use lagrangian::Lagrangian;

#[derive(Lagrangian)]
#[lagrangian(
    coordinates(x, y),
    kinetic = 0.5 * m * dot(x, y).powi(2),
)]
struct Model {
    m: f64,
}

fn main() {}
