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
    let start = State::new(0.0, [0.0], [0.0]);
    let cart = || Problem::new(&cart, start);
    let _ = cart().feedback(|state| -state.q[0]);
    let _ = cart().feedback(|state| [-state.q[0]; 3]);
    let _ = cart().feedback(|_| [1, 2]);
    let _ = cart().feedback(|state: &State<f64, 2>| [state.q[0], 0.0]);
    let _ = cart().feedback_with_states([0.0], |state, z| [z[0], state.q[0]]);
    let _ = cart().driven_by([1.0]).lagged([0.1, 0.2]);
    let _ = Problem::new(&Free { m: 1.0 }, start).feedback(|state| -state.q[0]);
}
