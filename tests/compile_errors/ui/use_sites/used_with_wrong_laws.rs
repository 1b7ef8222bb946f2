use lagrangian::prelude::*;

#[derive(Lagrangian)]
#[lagrangian(
    coordinates(x),
    kinetic = 0.5 * m * dot(x).powi(2),
    force(x = push + pull),
)]
struct Cart {
    m: f64,
    #[lagrangian(input)]
    push: f64,
    #[lagrangian(input)]
    pull: f64,
}

#[derive(Lagrangian)]
#[lagrangian(coordinates(x), kinetic = 0.5 * m * dot(x).powi(2))]
struct Free {
    m: f64,
}

fn main() {
    let cart = Cart { m: 1.0, push: 0.0, pull: 0.0 };
    let _ = cart.controlled_by(|state| -state.q[0]);
    let _ = cart.controlled_by(|state| [-state.q[0]; 3]);
    let _ = cart.controlled_by(|_| [1, 2]);
    let _ = cart.controlled_by(|state: &State<f64, 2>| [state.q[0], 0.0]);
    let _ = cart.with_controller(|state, z| [z[0], state.q[0]]);
    let _ = Free { m: 1.0 }.controlled_by(|state| -state.q[0]);
}
