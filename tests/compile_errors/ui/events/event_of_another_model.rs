use lagrangian::prelude::*;

#[derive(Lagrangian)]
#[lagrangian(coordinates(x), kinetic = 0.5 * m * dot(x).powi(2), event(wall = x, gate = x - 1.0))]
struct Cart {
    m: f64,
}

#[derive(Lagrangian)]
#[lagrangian(coordinates(h), kinetic = 0.5 * m * dot(h).powi(2), event(floor = h))]
struct Ball {
    m: f64,
}

fn main() {
    let ball = Ball { m: 1.0 };
    let problem = || Problem::new(&ball, State::new(0.0, [1.0], [-1.0]));
    let _ = problem().on(Cart::WALL).falling().record();
    let _ = problem().on([Cart::WALL, Cart::GATE]).record();
    let _ = problem().on([Ball::FLOOR, Cart::GATE]).record();
    let _ = problem().on(0).record();
}
