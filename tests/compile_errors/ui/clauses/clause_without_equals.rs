use lagrangian::Lagrangian;

#[derive(Lagrangian)]
#[lagrangian(
    coordinates(theta),
    kinetic
)]
struct Model {
    m: f64,
    g: f64,
    l: f64,
}

fn main() {}
