use lagrangian::prelude::*;

#[derive(Lagrangian)]
#[lagrangian(
    coordinates(r, phi),
    kinetic = 0.5 * m * (dot(r).powi(2) + (r * dot(phi)).powi(2)),
    potential = -m * mu / r,
    output(rate = dot(phi), position = r * [cos(phi), sin(phi)]),
    event(apsis = dot(r), turned = sin(phi)),
    taylor,
    routhian(RadialMotion),
)]
struct Orbit {
    m: f64,
    mu: f64,
}

fn main() -> Result<(), IntegrationError> {
    // The errors are those above alone.
    let (radial, start) = Orbit { m: 1.0, mu: 1.0 }.reduce(&State::new(0.0, [1.0, 0.0], [0.0, 1.1]));
    let rest: RadialMotion = RadialMotion { m: 1.0, mu: 1.0, p_phi: radial.p_phi };
    let outputs = rest.outputs(&start);
    let _ = (outputs.rate, outputs.position.x, RadialMotion::APSIS, RadialMotion::EVENTS);
    let _ = radial.effective_potential(&State::new(0.0, [1.0], [0.0]));
    let equations = radial.reconstruction();
    let end = Problem::new(&equations, (start, [0.0]).into()).solve(1.0, Taylor::new())?;
    let _ = equations.full_state(&end).q[Orbit::PHI] + start.q[RadialMotion::R];
    Ok(())
}
