use lagrangian::prelude::*;

#[derive(Lagrangian)]
#[lagrangian(
    coordinates(q[2]),
    define(
        r[0] = rotation_z(q[0]),
        r[i] = r[i - 1] * rotation_y(q[1]) * rotation_x(q[0]) for i in 1..100_000,
        p[0] = [0.0, 0.0, 0.0],
        p[i] = p[i - 1] + r[i - 1] * [1.0, 0.0, 0.0] for i in 1..100_000,
    ),
    body(link = (r[i], p[i]) for i in 0..100_000),
)]
struct Chain {
    link: RigidBody,
}

fn main() {}
