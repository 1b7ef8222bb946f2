use lagrangian::prelude::*;

#[derive(Lagrangian)]
#[lagrangian(
    coordinates(phi, theta, psi),
    define(r = rotation_zxz(phi, theta, psi), o = [0.0, 0.0, 0.0]),
    body(top = (r, o)),
    lagrangian = 0.5 * top.mass * dot(phi).powi(2),
)]
struct Top {
    top: RigidBody,
}

fn main() {}
