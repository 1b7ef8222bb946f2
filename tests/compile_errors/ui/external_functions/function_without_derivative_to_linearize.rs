use lagrangian::prelude::*;

#[derive(Lagrangian)]
#[lagrangian(
    coordinates(x),
    function(lift(alpha, speed) = alpha.sin() * speed, derivative(alpha) = cos(alpha) * speed),
    kinetic = 0.5 * m * dot(x).powi(2),
    force(x = lift(0.1 * x, dot(x))),
)]
struct Model {
    m: f64,
}

fn main() {}
