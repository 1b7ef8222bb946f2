use lagrangian::Lagrangian;

#[derive(Lagrangian)]
#[lagrangian(
    coordinates(x),
    kinetic = 0.5 * m * dot(x).powi(2),
    event(wall = [[x, 1.0], [0.0, x]]),
)]
struct Model {
    m: f64,
}

fn main() {}
