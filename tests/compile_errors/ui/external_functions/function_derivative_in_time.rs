use lagrangian::prelude::*;

#[derive(Lagrangian)]
#[lagrangian(
    coordinates(x),
    function(drag(v) = v * v, derivative(v) = dot(v)),
    kinetic = 0.5 * m * dot(x).powi(2),
    force(x = -drag(dot(x))),
)]
struct Model {
    m: f64,
}

fn main() {}
