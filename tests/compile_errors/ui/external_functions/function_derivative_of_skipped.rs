use lagrangian::prelude::*;

#[derive(Lagrangian)]
#[lagrangian(
    scalar = f64,
    coordinates(x),
    function(drag(v) = self.table[0] * v, derivative(v) = table[0]),
    kinetic = 0.5 * m * dot(x).powi(2),
    force(x = -drag(dot(x))),
)]
struct Model {
    m: f64,
    #[lagrangian(skip)]
    table: [f64; 1],
}

fn main() {}
