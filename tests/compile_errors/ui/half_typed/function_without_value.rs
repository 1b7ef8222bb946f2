use lagrangian::prelude::*;

#[derive(Lagrangian)]
#[lagrangian(
    coordinates(x),
    function(stribeck(v), derivative(v) = 2.0 * v),
    function(lift(v) =, derivative(v) = 2.0 * v),
    kinetic = 0.5 * m * dot(x).powi(2),
    force(x = -stribeck(dot(x)) - lift(x)),
)]
struct Model {
    m: f64,
}

fn main() {}
