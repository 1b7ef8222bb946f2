use lagrangian::prelude::*;

fn drag<S: Scalar>(v: S) -> S {
    v * v.abs()
}

#[derive(Lagrangian)]
#[lagrangian(
    taylor,
    coordinates(x),
    function(drag(v) = drag(v), derivative(v) = 2.0 * abs(v)),
    kinetic = 0.5 * m * dot(x).powi(2),
    force(x = -drag(dot(x))),
)]
struct Sledge {
    m: f64,
}

fn main() {}
