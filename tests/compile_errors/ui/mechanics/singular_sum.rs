use lagrangian::Lagrangian;

#[derive(Lagrangian)]
#[lagrangian(
    coordinates(x, y),
    kinetic = 0.5 * m * (dot(x) + dot(y)).powi(2),
)]
struct Model {
    m: f64,
}

fn main() {
    let model = Model { m: 1.0 };
    let state = lagrangian::State::new(0.0, [0.0, 0.0], [1.0, 1.0]);
    let _ = lagrangian::Lagrangian::accelerations(&model, &state);
}
