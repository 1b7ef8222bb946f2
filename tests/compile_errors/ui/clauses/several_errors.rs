use lagrangian::Lagrangian;

#[derive(Lagrangian)]
#[lagrangian(
    coordinates(theta, theta),
    kinetic = 0.5 * m * l ^ 2 * dot(theta).powi(2),
    potentail = -m * g * l * cos(theta),
    force(phi = 1.0),
    output(height = l * csc(theta), depth = height),
)]
struct Model {
    m: f64,
    g: f64,
    l: u8,
    #[lagrangian(parameter)]
    t: f64,
}

fn main() {}
