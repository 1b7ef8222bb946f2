use lagrangian::Lagrangian;

#[derive(Lagrangian)]
#[lagrangian(coordinates(theta), kinetic = 0.5 * m * dot(theta).powi(2))]
enum Model {
    One,
}

fn main() {
    let _ = Model::One;
    let state = lagrangian::State::new(0.0, [0.0], [1.0]);
    let _ = lagrangian::Lagrangian::accelerations(&Model::One, &state);
    let _ = Model::THETA;
}
