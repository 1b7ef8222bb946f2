use lagrangian::prelude::*;

#[derive(Lagrangian)]
#[lagrangian(
    coordinates(x),
    function(drag(v, v, m, t, PI) = v),
    kinetic = 0.5 * m * dot(x).powi(2),
)]
struct Model {
    m: f64,
}

fn main() {}
