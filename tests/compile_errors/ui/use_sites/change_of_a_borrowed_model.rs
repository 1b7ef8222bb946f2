use lagrangian::prelude::*;

#[derive(Lagrangian)]
#[lagrangian(
    coordinates(y),
    kinetic = 0.5 * m * dot(y).powi(2),
    potential = m * g * y,
    event(floor = y),
)]
struct Ball {
    m: f64,
    g: f64,
}

fn main() {
    let ball = Ball { m: 1.0, g: 9.81 };
    let start = State::new(0.0, [1.0], [0.0]);
    // The ball belongs to `main`: a reaction changes its state alone.
    let _ = Problem::new(&ball, start)
        .on(Ball::FLOOR)
        .then_with(|_, ball| ball.change(|ball| ball.m = 0.5));
}
