use lagrangian::prelude::*;

#[derive(Lagrangian)]
#[lagrangian(
    taylor,
    hamiltonian,
    coordinates(x),
    kinetic = 0.5 * m * dot(x).powi(2),
    potential = 0.5 * k * x.powi(2),
)]
struct Oscillator {
    m: f64,
    k: f64,
}

fn main() {
    let oscillator = Oscillator { m: 1.0, k: 4.0 };
    let equations = oscillator.canonical_equations();
    let start = equations.canonical(&State::new(0.0, [1.0], [0.0]));
    let _ = Taylor::new().integrate_to(&equations, start, 1.0);
}
