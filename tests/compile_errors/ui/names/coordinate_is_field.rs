use lagrangian::Lagrangian;

#[derive(Lagrangian)]
#[lagrangian(
    coordinates(theta, m),
    kinetic = 0.5 * (dot(theta).powi(2) + dot(m).powi(2)),
    potential = -m * g * l * cos(theta),
)]
struct Model {
    m: f64,
    g: f64,
    l: f64,
}

fn main() {}
