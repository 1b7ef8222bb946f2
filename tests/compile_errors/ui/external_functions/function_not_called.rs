use lagrangian::prelude::*;

#[derive(Lagrangian)]
#[lagrangian(
    coordinates(x),
    function(stribeck(v) = v * v, derivative(v) = 2.0 * v),
    kinetic = 0.5 * m * dot(x).powi(2),
    force(x = -stribeck * dot(x)),
)]
struct Model {
    m: f64,
}

fn main() {}
