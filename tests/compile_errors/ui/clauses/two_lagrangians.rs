use lagrangian::Lagrangian;

#[derive(Lagrangian)]
#[lagrangian(
    coordinates(theta),
    lagrangian = 0.5 * m * dot(theta).powi(2),
    lagrangian = -m * g * l * cos(theta),
)]
struct Model {
    m: f64,
    g: f64,
    l: f64,
}

fn main() {}
