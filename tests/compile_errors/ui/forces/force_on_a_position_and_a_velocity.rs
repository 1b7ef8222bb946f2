use lagrangian::Lagrangian;

#[derive(Lagrangian)]
#[lagrangian(
    coordinates(x, y),
    define(
        e = x + c * dot(x),
        v = [dot(x) - rate * y, dot(y) + rate * x],
        moving = dot(x) - dot(rate * t) * y,
    ),
    kinetic = 0.5 * m * (dot(x).powi(2) + dot(y).powi(2)),
    force(e = 1.0, v = [1.0, 2.0], moving = c),
)]
struct Model {
    m: f64,
    c: f64,
    rate: f64,
}

fn main() {}
