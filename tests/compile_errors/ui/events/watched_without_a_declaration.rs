use lagrangian::Lanes;
use lagrangian::prelude::*;

#[derive(Lagrangian)]
#[lagrangian(coordinates(x), kinetic = 0.5 * m * dot(x).powi(2))]
struct Silent {
    m: f64,
}

#[derive(Lagrangian)]
#[lagrangian(coordinates(x), kinetic = 0.5 * m * dot(x).powi(2), event(wall = x))]
struct Declaring {
    m: f64,
}

#[derive(Lagrangian)]
#[lagrangian(coordinates(x), kinetic = 0.5 * m * dot(x).powi(2), force(x = push))]
struct Pushed {
    m: f64,
    #[lagrangian(input)]
    push: f64,
}

fn main() {
    let start = State::new(0.0, [1.0], [-1.0]);
    let driver = Dop853::new().driver().declared_events([(0, Event::falling())]);
    let _ = driver.clone().run_until(&Silent { m: 1.0 }.dynamics(), start, 1.0);
    let pushed = Pushed { m: 1.0, push: 0.0 };
    let controlled = pushed.controlled_by(|state| -state.q[0]);
    let _ = driver.clone().run_until(&controlled, start, 1.0);
    // Two motions at once have no common events.
    let start = State::new(Lanes([0.0; 2]), [Lanes([1.0, 2.0])], [Lanes([-1.0; 2])]);
    let _ = driver.run_until(&Declaring { m: 1.0 }.dynamics(), start, 1.0);
}
