use lagrangian::prelude::*;

#[derive(Lagrangian)]
#[lagrangian(
    coordinates(phi, theta, psi),
    define(r = rotation_zxz(phi, theta, psi), o = [0.0, 0.0, 0.0]),
    kinetic = kinetic_energy(top, r) + top.kinetic_energy(r),
    potential = potential_energy(top, r, o),
)]
struct Top {
    top: RigidBody,
}

fn main() {}
