use lagrangian::prelude::*;

#[derive(Lagrangian)]
#[lagrangian(
    coordinates(x),
    define(r = 2.0 * identity(3)),
    body(block = (r, [x, 0.0, 0.0])),
    potential = potential_energy(block, diagonal([1.0, -1.0, 1.0]), [0.0, x, 0.0], [0.0, 0.0, -9.81]),
)]
struct Slide {
    block: RigidBody,
}

fn main() {}
