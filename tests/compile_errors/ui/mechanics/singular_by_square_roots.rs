use lagrangian::Lagrangian;

#[derive(Lagrangian)]
#[lagrangian(
    coordinates(x, y),
    kinetic = 0.5 * m * (dot(x).powi(2) + 2.0 * (a * b).sqrt() * dot(x) * dot(y) + a * b * dot(y).powi(2)),
)]
struct Model {
    m: f64,
    a: f64,
    b: f64,
}

fn main() {}
