use lagrangian::{Lagrangian, State};

#[derive(Lagrangian)]
#[lagrangian(
    coordinates(phi, theta, theta),
    define(
        w1 = dot(phi) * sin(theta) * sin(psi) + dot(theta) * cos(psi),
        w2 = dot(phi) * sin(theta) * cos(psi) - dot(theta) * sin(psi),
        w3 = dot(phi) * cos(theta) + dot(psi),
    ),
    kinetic = 0.5 * (i1 * w1.powi(2) + i2 * w2.powi(2) + i3 * w3.powi(2)),
    potential = m * g * l * cos(theta),
    output(spin = w3),
)]
struct HeavyTop {
    i1: f64,
    i2: f64,
    i3: f64,
    m: f64,
    g: f64,
    l: f64,
}

fn main() {
    let top = HeavyTop { i1: 1.0, i2: 1.0, i3: 2.0, m: 1.0, g: 9.81, l: 0.1 };
    let state = State::new(0.0, [0.0, 0.5, 0.0], [0.3, 0.0, 20.0]);
    let tilt: f64 = state.q[HeavyTop::THETA];
    let accelerations = top.accelerations(&state);
    let total = top.kinetic_energy(&state) + top.potential_energy(&state) - top.energy(&state);
    let linearization = top.linearize(&state);
    let pivots = top.relative_pivots(&state);
    let spin: f64 = top.outputs(&state).spin;
    println!("{tilt} {accelerations} {total} {} {pivots} {spin}", linearization.position);
    println!("{:?} {}", HeavyTop::COORDINATES, HeavyTop::EQUATIONS);
    println!("{:?}", HeavyTop::OPERATIONS.accelerations);
}
