use lagrangian::prelude::*;
use nalgebra::SVector;

#[derive(Lagrangian)]
#[lagrangian(
    coordinates(x, theta),
    kinetic = 0.5 * cart * dot(x).powi(2) + 0.5 * m * l ^ 2 * dot(theta).powi(2),
    force(x = push),
)]
struct CartPole {
    cart: f64,
    m: f64,
    l: f64,
    #[lagrangian(input)]
    push: f64,
}

fn main() {
    let model = CartPole { cart: 1.0, m: 0.1, l: 0.5, push: 0.0 };
    let state = State::new(0.0, [0.0, 0.1], [0.0, 0.0]);
    let pushed = model.with_inputs([1.0]);
    println!("{}", pushed.accelerations(&state)[CartPole::X]);
    println!("{}", model.input_jacobian(&state));
    let problem = Problem::new(&model, state);
    let controlled = problem.clone().feedback(|state| SVector::from([-state.q[1]]));
    println!("{}", controlled.dynamics().inputs(&state)[CartPole::PUSH]);
    let _ = problem.feedback_with_states([0.0], |state, z| (z[0], [state.q[1].sin()]));
    println!("{:?} {}", CartPole::INPUTS, model.input_jacobian(&state));
    let end = controlled.solve(1.0, Dop853::new());
    println!("{:?}", end.map(|end| end.last));
}
