use lagrangian::Lagrangian;

#[derive(Lagrangian)]
struct Model {
    m: f64,
}

fn main() {
    let state = lagrangian::State::new(0.0, [0.0], [1.0]);
    let _ = Model { m: 1.0 }.accelerations(&state);
}
