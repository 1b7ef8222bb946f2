use lagrangian::prelude::*;

#[derive(Lagrangian)]
#[lagrangian(
    coordinates(x),
    function(hill(x, steepness) = x.sin() * steepness),
    kinetic = 0.5 * m * dot(x).powi(2),
    potential = m * hill(x, m),
)]
struct Model {
    m: f64,
}

fn main() {}
