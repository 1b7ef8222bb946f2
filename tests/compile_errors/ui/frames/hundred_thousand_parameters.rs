use lagrangian::prelude::*;

#[derive(Lagrangian)]
#[lagrangian(
    coordinates(q[100_000]),
    define(r[i] = rotation_z(q[i]) for i in 0..100_000),
    body(link[i] = (r[i], [0.0, 0.0, 0.0]) for i in 0..100_000),
)]
struct Chain {
    link: [RigidBody; 100_000],
}

fn main() {}
