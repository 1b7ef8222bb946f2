use lagrangian::prelude::*;

#[derive(Lagrangian)]
#[lagrangian(
    coordinates(x),
    function(drag(speed) = speed * speed, derivative(spede) = 2.0 * speed, derivative(m) = 0.0),
    kinetic = 0.5 * m * dot(x).powi(2),
    force(x = -drag(dot(x))),
)]
struct Model {
    m: f64,
}

fn main() {}
