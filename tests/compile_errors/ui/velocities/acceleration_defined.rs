use lagrangian::Lagrangian;

#[derive(Lagrangian)]
#[lagrangian(
    coordinates(theta),
    define(acceleration = dot(dot(theta))),
    kinetic = 0.5 * m * dot(theta).powi(2),
    force(theta = -acceleration),
)]
struct Model {
    m: f64,
}

fn main() {}
