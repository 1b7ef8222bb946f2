use lagrangian::Lagrangian;

#[derive(Lagrangian)]
#[lagrangian(
    coordinates(theta, x),
    define(h[0] = x, h[0][1] = x),
    kinetic = 0.5 * m * (dot(theta).powi(2) + dot(x).powi(2)),
)]
struct Model {
    m: f64,
    g: f64,
    l: f64,
}

fn main() {}
