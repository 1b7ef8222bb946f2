use lagrangian::analysis::TangentSpace;
use lagrangian::prelude::*;

#[derive(Lagrangian)]
#[lagrangian(
    scalar = f64,
    coordinates(x, y),
    kinetic = 0.5 * m * (dot(x).powi(2) + dot(y).powi(2)),
    potential = m * g * y,
    constraint(rod = x.powi(2) + y.powi(2) - l.powi(2)),
)]
struct Model {
    m: f64,
    g: f64,
    l: f64,
}

fn main() {
    let model = Model { m: 1.0, g: 9.81, l: 1.0 };
    let state = State::new(0.0, [0.0, -1.0], [0.0, 0.0]);
    let _ = TangentSpace::at(&model, &state);
}
