use lagrangian::prelude::*;

#[derive(Lagrangian)]
#[lagrangian(
    coordinates(q[2]),
    define(r = 2.0 * rotation_z(q[0]), s = diagonal([1.0, 1.0, -1.0]) * rotation_y(q[1])),
    body(upper = (r, [0.0, 0.0, 0.0]), lower = (s, [1.0, 0.0, 0.0])),
)]
struct Arm {
    upper: RigidBody,
    lower: RigidBody,
}

fn main() {}
