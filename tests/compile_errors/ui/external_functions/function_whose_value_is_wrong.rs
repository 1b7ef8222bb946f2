use lagrangian::prelude::*;

#[derive(Lagrangian)]
#[lagrangian(
    coordinates(x),
    scalar = f64,
    function(drag(v) = self.table.nothing(v), derivative(v) = 2.0 * v),
    function(lift(v) = outside::lift(v), derivative(v) = 1.0),
    function(wind() = "strong"),
    kinetic = 0.5 * m * dot(x).powi(2),
    force(x = -drag(dot(x)) + lift(x) * wind()),
)]
struct Model {
    m: f64,
    #[lagrangian(skip)]
    table: Vec<f64>,
}

fn main() {}
