use lagrangian::prelude::*;

#[derive(Lagrangian)]
#[lagrangian(coordinates(x), kinetic = 0.5 * m * dot(x).powi(2))]
struct Particle {
    m: f64,
}

fn main() {
    let particle = Particle { m: 1.0 };
    let start = State::new(0.0, [0.0], [1.0]);
    let _ = Problem::new(&particle, start).save(0.1).solve(1.0, Dop853::new());
}
