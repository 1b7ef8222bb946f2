use lagrangian::prelude::*;

#[derive(Lagrangian)]
#[lagrangian(
    coordinates(x),
    function(drag(v, area) = v * v * area, derivative(v) = 2.0 * v * area),
    kinetic = 0.5 * m * dot(x).powi(2),
    force(x = -drag(dot(x)) - dot(x).drag()),
)]
struct Model {
    m: f64,
}

fn main() {}
