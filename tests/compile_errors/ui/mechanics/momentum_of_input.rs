use lagrangian::Lagrangian;

#[derive(Lagrangian)]
#[lagrangian(
    coordinates(theta),
    kinetic = 0.5 * m * dot(theta).powi(2) + u * dot(theta),
)]
struct Model {
    m: f64,
    #[lagrangian(input)]
    u: f64,
}

fn main() {
    
    let model = Model { m: 1.0, u: 0.0 };
    let state = lagrangian::State::new(0.0, [0.0], [1.0]);
    let _ = lagrangian::Lagrangian::accelerations(&model.with_inputs([1.0]), &state);
}
