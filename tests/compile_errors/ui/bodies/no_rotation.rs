use lagrangian::prelude::*;

#[derive(Lagrangian)]
#[lagrangian(
    coordinates(phi, theta, psi),
    define(r = rotation_zxz(phi, theta, psi), o = [0.0, 0.0, 0.0]),
    body(top = (2.0 * r, o)),
)]
struct Top {
    top: RigidBody,
}

fn main() {}
