use lagrangian::Lagrangian;

#[derive(Lagrangian)]
#[lagrangian(
    coordinates(x),
    kinetic = 0.5 * m * dot(x).powi(2),
    event(wall[i] = x - i for i in 0..2),
)]
struct Model {
    m: f64,
}

fn main() {}
