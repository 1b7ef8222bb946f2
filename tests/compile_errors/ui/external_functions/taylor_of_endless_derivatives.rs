use lagrangian::prelude::*;

/// f′(x) = 2 f(2 x) for 0 < x < 1.
fn fabius<S: Scalar>(x: S) -> S {
    x
}

#[derive(Lagrangian)]
#[lagrangian(
    taylor,
    coordinates(x),
    function(fabius(x) = fabius(x), derivative(x) = 2.0 * fabius(2.0 * x)),
    kinetic = 0.5 * m * dot(x).powi(2),
    force(x = fabius(x)),
)]
struct Smooth {
    m: f64,
}

fn main() {}
