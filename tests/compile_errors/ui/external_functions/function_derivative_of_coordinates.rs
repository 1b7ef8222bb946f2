use lagrangian::prelude::*;

#[derive(Lagrangian)]
#[lagrangian(
    coordinates(x, theta[2]),
    function(drag(v) = v * v, derivative(v) = 2.0 * v * x + t * height + wind),
    function(lift(v) = v * v, derivative(v) = 2.0 * theta[1]),
    define(height = x),
    kinetic = 0.5 * m * dot(x).powi(2),
    force(x = -drag(dot(x))),
)]
struct Model {
    m: f64,
    #[lagrangian(input)]
    wind: f64,
}

fn main() {}
