use lagrangian::prelude::*;

#[derive(Lagrangian)]
#[lagrangian(
    coordinates(phi, theta, psi),
    define(r = rotation_zxz(phi, theta, psi), o = [0.0, 0.0, 0.0]),
    body(top = (identity(3), o)),
)]
struct Top {
    top: RigidBody,
}

fn main() {}
