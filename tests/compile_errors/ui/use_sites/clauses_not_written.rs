use lagrangian::prelude::*;

#[derive(Lagrangian)]
#[lagrangian(
    coordinates(x),
    lagrangian = 0.5 * m * dot(x).powi(2) - 0.5 * m * x.powi(2) * sin(t),
)]
struct Plain {
    m: f64,
}

fn has_outputs<M: lagrangian::quantities::Outputs<1>>(_: &M) {}

fn main() {
    let plain = Plain { m: 1.0 };
    let state = State::new(0.0, [0.0], [1.0]);
    let _ = Problem::new(&plain, state).feedback(|state| -state.q[0]);
    let _ = plain.with_inputs([1.0]);
    let _ = plain.outputs(&state);
    let _ = plain.event_functions(&state);
    let _ = plain.sensitivities(&state);
    let _ = plain.regressor(&state, &state.v);
    let _ = plain.canonical_equations();
    let _ = plain.energy_rate(&state);
    let _ = plain.kinetic_energy(&state);
    let _ = plain.effective_potential(&state);
    let _ = plain.constants_of_motion(&state);
    let _ = Plain::INPUTS;
    let _ = Plain::C_SOURCE;
    let _ = plain.check_derivatives("friction", [0.0..1.0]);
    has_outputs(&plain);
}
