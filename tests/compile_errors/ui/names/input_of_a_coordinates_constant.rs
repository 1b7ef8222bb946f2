use lagrangian::prelude::*;

#[derive(Lagrangian)]
#[lagrangian(
    coordinates(x),
    kinetic = 0.5 * m * dot(x).powi(2),
    force(x = X),
)]
struct Model {
    m: f64,
    #[lagrangian(input)]
    X: f64,
}

fn main() {
    let model = Model { m: 1.0, X: 0.0 };
    let _ = Model::X;
    let start = State::new(0.0, [0.0], [0.0]);
    let _ = Problem::new(&model, start).feedback(|state| -state.q[Model::X].abs());
}
