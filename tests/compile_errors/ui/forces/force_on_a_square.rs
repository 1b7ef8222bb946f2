use lagrangian::Lagrangian;

#[derive(Lagrangian)]
#[lagrangian(
    coordinates(theta, x),
    define(e = 0.5 * dot(x).powi(2)),
    kinetic = 0.5 * m * (dot(theta).powi(2) + dot(x).powi(2)),
    force(e = g),
)]
struct Model {
    m: f64,
    g: f64,
    l: f64,
}

fn main() {}
