use lagrangian::prelude::*;

#[derive(Lagrangian)]
#[lagrangian(
    coordinates(x, y),
    kinetic = 0.5 * m * (dot(x).powi(2) + dot(y).powi(2)),
)]
struct Model {
    m: f64,
}

fn main() {
    let model = Model { m: 1.0 };
    let too_many = State::new(0.0, [0.0; 3], [0.0; 3]);
    let _ = model.accelerations(&too_many);
    let _ = Problem::new(&model, too_many).solve(1.0, Dop853::new());
    let _ = State::new(0.0, [0.0; 2], [0.0; 3]);
    let _ = State::new(0.0, [0.0; 2], [0; 2]);
}
