use lagrangian::Lagrangian;

#[derive(Lagrangian)]
#[lagrangian(
    coordinates(dot),
    kinetic = 0.5 * m * dot(dot).powi(2),
)]
struct Model {
    m: f64,
    g: f64,
    l: f64,
}

fn main() {}
