use lagrangian::prelude::*;

#[derive(Lagrangian)]
#[lagrangian(taylor, coordinates(x), kinetic = 0.5 * m * dot(x).powi(2), force(x = push))]
struct Cart {
    m: f64,
    #[lagrangian(input)]
    push: f64,
}

#[derive(Lagrangian)]
#[lagrangian(coordinates(x), kinetic = 0.5 * m * dot(x).powi(2))]
struct Point {
    m: f64,
}

#[derive(Lagrangian)]
#[lagrangian(
    taylor,
    coordinates(x),
    function(pull(y) = times(self.k, y), derivative(y) = k),
    kinetic = 0.5 * dot(x).powi(2),
    force(x = -pull(x)),
)]
struct Spring {
    k: f64,
}

fn times<S: Scalar>(k: f64, y: S) -> S {
    S::from_f64(k) * y
}

fn start() -> State<f64, 1> {
    State::new(0.0, [1.0], [0.0])
}

fn main() {
    // A law that is a closure has no series.
    let fed_back = [1.0, 2.0].map(|m| {
        let cart = Cart { m, push: 0.0 };
        Problem::new(cart, start()).feedback(|x| -x.q[0])
    });
    let _ = Ensemble::new(fed_back).solve(1.0, Taylor::new());
    // No clause `taylor`.
    let points = [1.0, 2.0].map(|m| Problem::new(Point { m }, start()));
    let _ = Ensemble::new(points).solve(1.0, Taylor::new());
    // One function for all lanes.
    let springs = [1.0, 2.0].map(|k| Problem::new(Spring { k }, start()));
    let _ = Ensemble::new(springs).solve(1.0, Taylor::new());
    // An end that is none.
    let carts = [1.0, 2.0].map(|m| Problem::new(Cart { m, push: 0.0 }, start()));
    let _ = Ensemble::new(carts).solve([1.0, 2.0], Taylor::new());
}
