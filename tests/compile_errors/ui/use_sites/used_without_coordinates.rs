use lagrangian::{Lagrangian, State};

#[derive(Lagrangian)]
#[lagrangian(coordinates, kinetic = 0.5 * m * dot(theta).powi(2))]
struct Rotor {
    m: f64,
}

fn main() {
    let state = State::new(0.0, [0.0], [1.0]);
    let accelerations = Rotor { m: 1.0 }.accelerations(&state);
    println!("{}", accelerations[0]);
}
