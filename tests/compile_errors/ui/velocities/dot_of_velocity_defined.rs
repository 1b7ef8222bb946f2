use lagrangian::Lagrangian;

#[derive(Lagrangian)]
#[lagrangian(
    coordinates(theta),
    define(rate = dot(theta)),
    kinetic = 0.5 * m * dot(rate).powi(2),
)]
struct Model {
    m: f64,
}

fn main() {}
