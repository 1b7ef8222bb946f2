use lagrangian::analysis::StateSpace;
use lagrangian::prelude::*;

#[derive(Lagrangian)]
#[lagrangian(coordinates(x), kinetic = 0.5 * m * dot(x).powi(2), potential = 0.5 * k * x.powi(2))]
struct Oscillator {
    m: f64,
    k: f64,
}

fn main() {
    let oscillator = Oscillator { m: 1.0, k: 4.0 };
    let state = State::new(0.0, [0.0], [0.0]);
    let _ = StateSpace::<f64, 2, 1, 2>::of(&oscillator, &state);
}
