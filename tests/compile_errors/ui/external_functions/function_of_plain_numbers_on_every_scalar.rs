use lagrangian::prelude::*;

#[derive(Lagrangian)]
#[lagrangian(
    coordinates(x),
    function(drag(v) = drag(v), derivative(v) = 2.0 * v),
    kinetic = 0.5 * m * dot(x).powi(2),
    force(x = -drag(dot(x))),
)]
struct Model {
    m: f64,
}

fn drag(v: f64) -> f64 {
    v * v
}

fn main() {}
