use lagrangian::prelude::*;

#[derive(Lagrangian)]
#[lagrangian(
    coordinates(x),
    function(hill(x) = x.sin(), derivative(x) = slope(x)),
    function(slope(x) = x.cos()),
    kinetic = 0.5 * m * dot(x).powi(2),
    potential = m * hill(x),
)]
struct Model {
    m: f64,
}

fn main() {}
