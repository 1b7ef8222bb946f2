use lagrangian::prelude::*;

#[derive(Lagrangian)]
#[lagrangian(
    coordinates(q[2]),
    define(
        r = rotation_z(q[0]),
        elbow = elbow + r * [1.0, 0.0, 0.0],
    ),
    body(upper = (r, [0.0, 0.0, 0.0]), lower = (r * rotation_y(q[1]), elbow)),
)]
struct Arm {
    upper: RigidBody,
    lower: RigidBody,
}

fn main() {}
