use lagrangian::prelude::*;

#[derive(Lagrangian)]
#[lagrangian(
    coordinates(x),
    function(drag(v, w) = v * w, derivative(v, w) = 1.0),
    kinetic = 0.5 * m * dot(x).powi(2),
    force(x = -drag(dot(x), m)),
)]
struct Model {
    m: f64,
}

fn main() {}
