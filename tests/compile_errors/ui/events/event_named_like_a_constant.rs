use lagrangian::Lagrangian;

#[derive(Lagrangian)]
#[lagrangian(
    coordinates(x),
    kinetic = 0.5 * m * dot(x).powi(2),
    event(events = x),
)]
struct Model {
    m: f64,
}

fn main() {}
