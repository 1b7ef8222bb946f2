use lagrangian::{Lagrangian, State};

#[derive(Lagrangian)]
#[lagrangian(
    coordinates(theta),
    kinetic = 0.5 * inertia * dot(theta).powi(2),
)]
struct Rotor {
    moment: f64,
}

fn main() {
    let state = State::new(0.0, [0.0], [1.0]);
    let accelerations = Rotor { moment: 1.0 }.accelerations(&state);
    println!("{}", accelerations[Rotor::THETA]);
}
