use lagrangian::Lagrangian;

#[derive(Lagrangian)]
#[lagrangian(
    coordinates(theta),
    kinetic = 0.5 * t * dot(theta).powi(2),
)]
struct Model {
    t: f64,
}

fn main() {}
