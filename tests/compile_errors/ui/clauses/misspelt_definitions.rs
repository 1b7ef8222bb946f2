use lagrangian::Lagrangian;

#[derive(Lagrangian)]
#[lagrangian(
    coordinates(theta),
    defin(height = -l * cos(theta)),
    kinetic = 0.5 * m * l.powi(2) * dot(theta).powi(2),
    potential = m * g * height,
)]
struct Model {
    m: f64,
    g: f64,
    l: f64,
}

fn main() {
    let model = Model { m: 1.0, g: 9.81, l: 1.0 };
    let state = lagrangian::State::new(0.0, [0.0], [1.0]);
    let _ = state.q[Model::THETA];
    let _ = lagrangian::Lagrangian::accelerations(&model, &state);
}
