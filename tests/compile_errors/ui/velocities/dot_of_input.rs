use lagrangian::Lagrangian;

#[derive(Lagrangian)]
#[lagrangian(
    coordinates(theta),
    kinetic = 0.5 * m * dot(theta).powi(2),
    force(theta = dot(u)),
)]
struct Model {
    m: f64,
    #[lagrangian(input)]
    u: f64,
}

fn main() {}
