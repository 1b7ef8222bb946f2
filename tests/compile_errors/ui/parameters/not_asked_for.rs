use lagrangian::identification::Identification;
use lagrangian::prelude::*;

#[derive(Lagrangian)]
#[lagrangian(coordinates(x), kinetic = 0.5 * m * dot(x).powi(2))]
struct Particle {
    m: f64,
}

fn main() {
    let particle = Particle { m: 1.0 };
    let state = State::new(0.0, [0.0], [1.0]);
    let none = SVector::from([0.0]);
    Identification::<1>::new(["m"]).add(&particle, &state, &none, &none);
    let _ = particle.sensitivities::<1>(&state);
    let _ = particle.momentum_rates(&state);
    let _ = particle.energy_rate(&state);
}
