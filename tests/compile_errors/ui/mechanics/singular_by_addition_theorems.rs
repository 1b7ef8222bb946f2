use lagrangian::Lagrangian;

#[derive(Lagrangian)]
#[lagrangian(
    coordinates(x, y),
    define(
        along = dot(x) * cos(a - b) + dot(y) * sin(a - b),
        ahead = (dot(x) * cos(b) - dot(y) * sin(b)) * cos(a) + (dot(x) * sin(b) + dot(y) * cos(b)) * sin(a),
    ),
    kinetic = 0.5 * m * (along.powi(2) + ahead.powi(2)),
)]
struct Model {
    m: f64,
    a: f64,
    b: f64,
}

fn main() {}
