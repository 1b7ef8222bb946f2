use lagrangian::prelude::*;

#[derive(Lagrangian)]
#[lagrangian(
    coordinates(phi, theta, psi),
    define(r = rotation_zxz(phi, theta, psi), o = [0.0, 0.0, 0.0]),
    body(m = (r, o), missing = (r, o)),
)]
struct Top {
    m: f64,
}

fn main() {}
