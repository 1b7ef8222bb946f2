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

fn law(state: &State<f64, 1>) -> f64 {
    -state.q[0]
}

fn main() {
    let start = State::new(0.0, [1.0], [-1.0]);
    let _ = Problem::new(&Silent { m: 1.0 }, start).on(Declaring::WALL).falling().record();
    let pushed = Pushed { m: 1.0, push: 0.0 };
    let controlled = Problem::new(&pushed, start).feedback(law);
    let _ = controlled.on(Declaring::WALL).falling().record();
    // Two motions at once have no common events.
    let start = State::new(Lanes([0.0; 2]), [Lanes([1.0, 2.0])], [Lanes([-1.0; 2])]);
    let _ = Problem::new(&Declaring { m: 1.0 }, start).on(Declaring::WALL).falling().record();
}
