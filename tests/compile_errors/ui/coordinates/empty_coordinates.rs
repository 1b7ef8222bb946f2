use lagrangian::Lagrangian;

#[derive(Lagrangian)]
#[lagrangian(
    coordinates(),
    kinetic = 0.5 * m * g * l,
)]
struct Model {
    m: f64,
    g: f64,
    l: f64,
}

fn main() {}
