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
    let _ = Sensitivities::<1, 1>::sensitivities(&particle, &state);
    let _ = Hamiltonian::<1>::momentum_rates(&particle, &state);
    let _ = EnergyBalance::<1>::energy_rate(&particle, &state);
}
