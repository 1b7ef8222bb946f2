use lagrangian::prelude::*;

#[derive(Lagrangian)]
#[lagrangian(
    coordinates(phi, theta, psi),
    define(w = angular_velocity_zxz(phi, theta, psi)),
    kinetic = 0.5 * w.dot(diagonal([i, i, i_s]) * w),
    potential = wieght * cos(theta),
    output(spin = w.z),
    hamiltonian,
    sensitivities(i),
    taylor,
    routhian(Nutation),
)]
struct Top {
    i: f64,
    i_s: f64,
    weight: f64,
}

fn main() -> Result<(), IntegrationError> {
    // There is one error, the misspelt name.
    let top = Top { i: 0.4, i_s: 0.1, weight: 2.5 };
    let (nutation, start) = top.reduce(&State::new(0.0, [0.0, 0.5, 0.0], [0.2, 0.0, 40.0]));
    let _ = nutation.p_phi - nutation.p_psi * start.q[Nutation::THETA].cos();
    let _ = nutation.effective_potential(&start) + nutation.routhian(&start) + nutation.outputs(&start).spin;
    let [precession, spin] = nutation.ignorable_velocities(&start).into();
    let _: f64 = precession + spin + nutation.sensitivities(&start)[0];
    let equations = nutation.reconstruction();
    let end = Problem::new(&equations, (start, [0.0, 0.0]).into()).solve(10.0, Taylor::new())?;
    let _ = equations.full_state(&end).q[Top::PSI];
    let _ = nutation.linearize(&State::new(0.0, [0.5], [0.0]));
    Ok(())
}
