use lagrangian::prelude::*;

#[derive(Lagrangian)]
#[lagrangian(
    taylor,
    coordinates(x),
    kinetic = 0.5 * mass * dot(x).powi(2),
    event(wall = x, both = [x, dot(x)]),
)]
struct Model {
    m: f64,
}

fn main() {
    let model = Model { m: 1.0 };
    let start = State::new(0.0, [1.0], [-1.0]);
    let problem = Problem::new(&model, start).on(Model::WALL).falling().record();
    let _ = problem.on(Model::BOTH[1]).record().solve(1.0, Taylor::new());
    let _ = Model::EVENTS;
}
