use lagrangian::prelude::*;

#[derive(Lagrangian)]
#[lagrangian(
    coordinates(phi, theta, psi),
    define(r = rotation_zxz(phi, theta, psi), o = [0.0, 0.0, 0.0]),
    kinetic = 0.5 * top.mas * dot(r * top.centre).norm_squared(),
)]
struct Top {
    top: RigidBody,
}

fn main() {}
