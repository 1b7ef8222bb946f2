use lagrangian::Lagrangian;

#[derive(Lagrangian)]
#[lagrangian(
    coordinates(theta),
    kinetic = 0.5 * m * l.powi(2) * dot(theta).powi(2),
    potential = m * g * 2.0.powi(100000) * cos(theta),
)]
struct Model {
    m: f64,
    g: f64,
    l: f64,
}

fn main() {}
