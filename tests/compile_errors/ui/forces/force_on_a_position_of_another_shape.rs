use lagrangian::Lagrangian;

#[derive(Lagrangian)]
#[lagrangian(
    coordinates(theta, x),
    define(p = [x, theta]),
    kinetic = 0.5 * m * (dot(theta).powi(2) + dot(x).powi(2)),
    force(p = g),
)]
struct Model {
    m: f64,
    g: f64,
    l: f64,
}

fn main() {}
