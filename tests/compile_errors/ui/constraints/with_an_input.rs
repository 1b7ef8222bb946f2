use lagrangian::Lagrangian;

#[derive(Lagrangian)]
#[lagrangian(
    coordinates(x, y),
    kinetic = 0.5 * m * (dot(x).powi(2) + dot(y).powi(2)),
    potential = m * g * y,
    constraint(slider = x - pull),
)]
struct Model {
    m: f64,
    g: f64,
    #[lagrangian(input)]
    pull: f64,
}

fn main() {}
