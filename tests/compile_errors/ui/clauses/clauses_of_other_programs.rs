use lagrangian::prelude::*;

#[derive(Lagrangian)]
#[lagrangian(
    coords(x),
    T = 0.5 * m * dot(x).powi(2),
    V = 0.5 * m * x.powi(2),
    inputs(u),
    parameters(m),
    let y = x,
    fn f(x) = x,
    friction(x = 0.1),
    torque(x = 0.1),
    initial(x = 0.0),
    integrator = dop853,
    skip,
)]
struct Particle {
    m: f64,
}

#[derive(Lagrangian)]
#[lagrangian(coordinates(x), L = 0.5 * m * dot(x).powi(2), reduced(Rest))]
struct Reduced {
    m: f64,
}

fn main() {}
