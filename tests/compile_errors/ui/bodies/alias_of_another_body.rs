use lagrangian::prelude::*;

#[derive(Lagrangian)]
#[lagrangian(
    coordinates(phi, theta, psi),
    define(r = rotation_zxz(phi, theta, psi), o = [0.0, 0.0, 0.0]),
    body(top = (r, o)),
)]
struct Top {
    #[lagrangian(type = RigidBody)]
    top: PrincipalBody,
}

fn main() {}
