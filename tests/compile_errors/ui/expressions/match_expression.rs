use lagrangian::Lagrangian;

#[derive(Lagrangian)]
#[lagrangian(
    coordinates(theta),
    kinetic = 0.5 * m * l.powi(2) * dot(theta).powi(2),
    potential = match theta { _ => m * g * l },
)]
struct Model {
    m: f64,
    g: f64,
    l: f64,
}

fn main() {}
