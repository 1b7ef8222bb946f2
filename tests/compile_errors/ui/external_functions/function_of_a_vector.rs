use lagrangian::prelude::*;

#[derive(Lagrangian)]
#[lagrangian(
    coordinates(x),
    function(drag(v) = v * v, derivative(v) = 2.0 * v),
    kinetic = 0.5 * m * dot(x).powi(2),
    force(x = -drag([dot(x), 0.0])),
)]
struct Model {
    m: f64,
}

fn main() {}
