use lagrangian::Lagrangian;

struct RigidBody {
    mass: f64,
}

#[derive(Lagrangian)]
#[lagrangian(coordinates(x), kinetic = 0.5 * cart.mass * dot(x).powi(2))]
struct Cart {
    cart: RigidBody,
}

fn main() {}
