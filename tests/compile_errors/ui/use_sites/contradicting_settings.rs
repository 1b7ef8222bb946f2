use lagrangian::prelude::*;

#[derive(Lagrangian)]
#[lagrangian(taylor, coordinates(x), kinetic = 0.5 * m * dot(x).powi(2), force(x = push))]
struct Cart {
    m: f64,
    #[lagrangian(input)]
    push: f64,
}

fn main() {
    let cart = Cart { m: 1.0, push: 0.0 };
    let problem = || Problem::new(&cart, State::new(0.0, [0.0], [1.0]));
    // No series is known under a closure.
    let _ = problem().feedback(|x| -x.q[0]).solve(1.0, Taylor::new());
    // No event is declared.
    let _ = problem().on(0).stop();
    // What is kept is said once.
    let _ = problem().save(Every(0.1)).save(Dense);
    // The law comes before what is watched for.
    let _ = problem().when(|x| x.q[0]).stop().feedback(|x| -x.q[0]);
    // A state of two coordinates.
    let _ = Problem::new(&cart, State::new(0.0, [0.0, 1.0], [0.0, 0.0]));
    // A reaction returns nothing, or whether the motion goes on.
    let _ = problem().when(|x| x.q[0]).then(|x| x.v[0]);
    // Nothing to integrate.
    let _ = Problem::new(1.0, State::new(0.0, [0.0], [1.0]));
}
