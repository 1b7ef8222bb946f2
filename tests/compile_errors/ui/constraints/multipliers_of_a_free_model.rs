use lagrangian::prelude::*;

#[derive(Lagrangian)]
#[lagrangian(
    coordinates(x, y),
    kinetic = 0.5 * m * (dot(x).powi(2) + dot(y).powi(2)),
    potential = m * g * y,
)]
struct Model {
    m: f64,
    g: f64,
    l: f64,
}

fn main() {
    let model = Model { m: 1.0, g: 9.81, l: 1.0 };
    let state = State::new(0.0, [0.0, -1.0], [0.0, 0.0]);
    let _ = model.multipliers(&state);
    let _ = model.constraint_residuals(&state);
    let _ = model.assemble(state);
}
