use lagrangian::prelude::*;

#[derive(Lagrangian)]
#[lagrangian(coordinates(x), kinetic = 0.5 * m * dot(x).powi(2), force(x = push))]
struct Cart {
    m: f64,
    #[lagrangian(input)]
    push: f64,
}

fn main() {
    let cart = Cart { m: 1.0, push: 0.0 };
    let state = State::new(0.0, [0.0], [0.0]);
    let _ = cart.with_inputs([1.0, 2.0]).accelerations(&state);
}
