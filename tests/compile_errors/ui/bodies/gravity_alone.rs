use lagrangian::prelude::*;

#[derive(Lagrangian)]
#[lagrangian(
    coordinates(phi, theta, psi),
    define(r = rotation_zxz(phi, theta, psi), o = [0.0, 0.0, 0.0]),
    kinetic = kinetic_energy(top, r, o),
    gravity = [0.0, 0.0, -9.81],
)]
struct Top {
    top: RigidBody,
}

fn main() {}
