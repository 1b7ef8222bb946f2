use lagrangian::prelude::*;

#[derive(Lagrangian)]
#[lagrangian(
    coordinates(phi, theta, psi),
    define(r = rotation_zxz(phi, theta, psi), o = [0.0, 0.0, 0.0]),
    body(top = (r, o)),
    gravity = [0.0, 0.0, -9.81],
    gravity = [0.0, 0.0, -1.62],
)]
struct Top {
    top: RigidBody,
}

fn main() {}
