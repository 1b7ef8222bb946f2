use lagrangian::prelude::*;

#[derive(Lagrangian)]
#[lagrangian(
    coordinates(phi, theta, psi),
    define(r = rotation_zxz(phi, theta, psi), o = [0.0, 0.0, 0.0]),
    kinetic = kinetic_energy(top, r, o) + dot(phi) * top + dot(psi) * wheels[0],
)]
struct Top {
    top: PrincipalBody,
    wheels: [SymmetricBody; 2],
}

fn main() {}
