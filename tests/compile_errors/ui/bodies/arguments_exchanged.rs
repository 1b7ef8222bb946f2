use lagrangian::prelude::*;

#[derive(Lagrangian)]
#[lagrangian(
    coordinates(phi, theta, psi),
    define(r = rotation_zxz(phi, theta, psi), o = [0.0, 0.0, 0.0]),
    body(top = (o, r)),
    gravity = [0.0, 0.0, -g],
)]
struct Top {
    top: RigidBody,
    g: f64,
}

fn main() {}
