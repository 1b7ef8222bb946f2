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
    let driver = Taylor::new()
        .driver()
        .declared_events([(Model::WALL, Event::falling()), (Model::BOTH[1], Event::either())]);
    let start = State::new(0.0, [1.0], [-1.0]);
    let _ = driver.run_until(&model.dynamics(), start, 1.0);
    let _ = Model::EVENTS;
}
