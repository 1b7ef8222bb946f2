use lagrangian::prelude::*;

#[derive(Lagrangian)]
#[lagrangian(coordinates(x), kinetic = 0.5 * m * dot(x).powi(2))]
struct Plain {
    m: f64,
}

#[derive(Lagrangian)]
#[lagrangian(taylor, coordinates(x), kinetic = 0.5 * m * dot(x).powi(2), force(x = push))]
struct Controlled {
    m: f64,
    #[lagrangian(input)]
    push: f64,
}

fn main() {
    let start = State::new(0.0, [0.0], [1.0]);
    let plain = Plain { m: 1.0 };
    let _ = Problem::new(&plain, start).solve(1.0, Taylor::new());
    let controlled = Controlled { m: 1.0, push: 0.0 };
    let plant = Problem::new(&controlled, start).feedback(|x| -x.q[0]);
    let _ = plant.solve(1.0, Taylor::new());
}
