use lagrangian::Lagrangian;

#[derive(Lagrangian)]
#[lagrangian(
    coordinates(q[3]),
    define(
        upper = lower * rotation_y(q[0]),
        middle = upper * rotation_y(q[1]),
        lower = middle * rotation_y(q[2]),
    ),
    kinetic = 0.5 * m * (0..3).map(|i| dot(q[i]).powi(2)).sum(),
)]
struct Model {
    m: f64,
}

fn main() {}
