use lagrangian::Lagrangian;

#[derive(Lagrangian)]
#[lagrangian(
    coordinates(x, y),
    kinetic = 0.5 * m * (dot(x).powi(2) + dot(y).powi(2)),
    potential = m * g * y,
    constraint(pin = [x, y]),
    compliance(pin = [1.0, 2.0, 3.0]),
)]
struct Model {
    m: f64,
    g: f64,
    l: f64,
    k: f64,
}

fn main() {}
