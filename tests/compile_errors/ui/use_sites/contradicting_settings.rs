use lagrangian::prelude::*;

#[derive(Lagrangian)]
#[lagrangian(taylor, coordinates(x), kinetic = 0.5 * m * dot(x).powi(2), force(x = push))]
struct Cart {
    m: f64,
    #[lagrangian(input)]
    push: f64,
}

fn place(state: &State<f64, 1>) -> f64 {
    state.q[0]
}

fn velocity(state: &mut State<f64, 1>) -> f64 {
    state.v[0]
}

fn main() {
    let cart = Cart { m: 1.0, push: 0.0 };
    let problem = || Problem::new(&cart, State::new(0.0, [0.0], [1.0]));
    // No event is declared.
    let _ = problem().on(0);
    // What is kept is said once.
    let _ = problem().save(Every(0.1)).save(Dense);
    // The law comes before what is watched for.
    let _ = problem().when(place).stop().feedback(place);
    // A state of two coordinates.
    let _ = Problem::new(&cart, State::new(0.0, [0.0, 1.0], [0.0, 0.0]));
    // A reaction returns nothing, or whether the motion goes on.
    let _ = problem().when(place).then(velocity);
    // Nothing to integrate.
    let _ = Problem::new(1.0, State::new(0.0, [0.0], [1.0]));
}
