use lagrangian::prelude::*;

#[derive(Lagrangian)]
#[lagrangian(
    coordinates(x),
    function(hill(x) = x.sin()),
    kinetic = 0.5 * m * dot(x).powi(2),
    output(rise = dot(hill(x))),
)]
struct Model {
    m: f64,
}

fn main() {}
