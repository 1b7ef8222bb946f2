/// A pole on a cart.
#[lagrangian(
    coordinates(x, theta),
    define(px = x + l * sin(theta), py = l * cos(theta)),
    kinetic = 0.5 * cart * dot(x).powi(2) + 0.5 * pole * (dot(px).powi(2) + dot(py).powi(2)),
    potential = pole * g * py,
    dissipation = 0.5 * friction * dot(x).powi(2),
    force(x = push),
)]
struct CartPole { cart: f64, pole: f64, l: f64, g: f64, friction: f64, #[lagrangian(input)] push: f64 }
