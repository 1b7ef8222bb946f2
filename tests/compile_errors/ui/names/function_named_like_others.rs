use lagrangian::prelude::*;

#[derive(Lagrangian)]
#[lagrangian(
    coordinates(x),
    function(sin(v) = v),
    function(t(v) = v),
    function(m(v) = v),
    function(x(v) = v),
    function(height(v) = v),
    function(cross(v) = v),
    define(height = x),
    kinetic = 0.5 * m * dot(x).powi(2),
)]
struct Model {
    m: f64,
}

fn main() {}
