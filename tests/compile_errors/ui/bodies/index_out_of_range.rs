use lagrangian::prelude::*;

#[derive(Lagrangian)]
#[lagrangian(
    coordinates(phi, theta, psi),
    define(r = rotation_zxz(phi, theta, psi), o = [0.0, 0.0, 0.0]),
    body(wheels[i] = (r, o) for i in 0..3),
)]
struct Top {
    wheels: [SymmetricBody; 2],
}

fn main() {}
