use lagrangian::Lagrangian;

#[derive(Lagrangian)]
#[lagrangian(
    crate = crate::,
    coordinates(x),
    kinetic = 0.5 * m * dot(x).powi(2),
)]
struct Model {
    m: f64,
}

fn main() {
    use lagrangian::Lagrangian as _;

    let state = lagrangian::State::new(0.0, [1.0], [0.0]);
    let _ = Model { m: 1.0 }.accelerations(&state)[Model::X];
}
