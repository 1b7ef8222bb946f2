use lagrangian::Lagrangian;

#[derive(Lagrangian)]
#[lagrangian(
    coordinates(r:, x),
    kinetic = 0.5 * m * (dot(x).powi(2) + dot(r).norm_squared()),
)]
struct Model {
    m: f64,
    g: f64,
    l: f64,
}

fn main() {}
